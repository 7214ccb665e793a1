// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "placing/pack_solids.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>

#include "common/run_limits.h"
#include "common/session.h"
#include "common/stop_on_interrupt.h"
#include "io/nesting/read_solids.h"
#include "io/nesting/write_solids.h"
#include "io/text/read_text.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_search/solid_search.h"
#include "placing/packing_report.h"

namespace findspace::app {
namespace {

constexpr std::size_t kFaultsNamed = 8;

io::SolidProblemRead read_problem(const Options& options, const std::string& text, const std::string& name) {
  if (options.height)
    throw Error(ErrorCode::kUsage, "--height is of strips in the plane; in space the height is sought", name);
  return io::read_solids(text, name, nesting_options(options), reading(options));
}

class SolidPacking {
 public:
  SolidPacking(const Options& options, const std::string& text, Reporter& reporter)
      : options_(options), reporter_(reporter) {
    check_outputs(options, {".json", ".svg", ".obj", ".off", ".stl", ".ply", ".glb", ".3mf", ".step"});
    io::SolidProblemRead read = read_problem(options, text, options.scene);
    for (const std::string& note : read.notes) reporter_.note(note);
    problem_ = std::move(read.problem);
    if (!problem_.in_containers()) facts_.lower_bound = packing::lower_bound(problem_);
  }

  Outcome run() {
    auto search = search_options<packing::SolidLayout>(options_);
    facts_.seed = search.seed;
    facts_.threads = search.threads;
    packing::SolidLayout start;
    if (options_.start) {
      start = start_layout();
      search.start = &start;
    }
    const packing::SolidSearchEvents events{[&](const auto& layout, const auto& state) { keep(layout, state); },
                                            [&](const auto& state) { show(state); }};
    std::optional<packing::SolidLayout> best;
    {
      const StopOnInterrupt interrupt;
      best = packing::search_solids(problem_, search, events, StopOnInterrupt::wanted());
    }
    if (!best) return empty();
    return {answer(*best), StopOnInterrupt::wanted() ? kInterrupted : kDone};
  }

 private:
  packing::SolidLayout start_layout() const {
    const std::string name = options_.start->string();
    packing::SolidLayout layout =
        io::read_solid_layout(io::read_text(*options_.start, options_.input_limit), name, problem_);
    const packing::SolidVerdict verdict = packing::verify(problem_, layout);
    if (!verdict.is_feasible())
      throw Error(ErrorCode::kBadValue,
                  "the layout to start with is not feasible: " + io::fault_text(problem_, layout, verdict.faults[0]),
                  name);
    return layout;
  }

  /// Every better layout is in its files at once.
  void keep(const packing::SolidLayout& layout, const packing::SearchState& state) {
    facts_.seconds = state.seconds;
    facts_.density = state.density;
    facts_.proven = packing::verify(problem_, layout).is_feasible();
    write(layout);
    answer_at_the_end(is_printed(options_) ? answer(layout) : "");
    if (!options_.quiet) reporter_.note(better_text(state, "height"));
  }

  void show(const packing::SearchState& state) { reporter_.stage(progress_text(state, "height")); }

  void write(const packing::SolidLayout& layout) const {
    Writers writers{{".json", [&] { return io::layout_json(problem_, layout, facts_); }},
                    {".svg", [&] { return io::layout_svg(problem_, layout, facts_); }}};
    for (const char* ending : {".obj", ".off", ".stl", ".ply", ".glb", ".3mf", ".step"})
      writers[ending] = [&, ending] {
        return io::assembly_text(io::layout_assembly(problem_, layout), problem_.name, ending, "");
      };
    write_outputs(options_, writers);
  }

  std::string answer(const packing::SolidLayout& layout) const {
    return options_.json ? io::layout_json(problem_, layout, facts_) : summary(layout);
  }

  std::string summary(const packing::SolidLayout& layout) const {
    std::string text = fmt::format("height {}", layout.height.text());
    if (problem_.in_containers())
      text = fmt::format("{} container{}, of the last {} used", layout.containers.size(),
                         layout.containers.size() == 1 ? "" : "s", layout.height.text());
    text += fmt::format(", density {:.4f} %, {} parts, proved free of overlaps\n", 100 * facts_.density,
                        layout.items.size());
    if (problem_.in_containers()) return text + left_out_text(problem_.parts, layout.left_out);
    const bool optimal = layout.height <= facts_.lower_bound;
    return text +
           (optimal ? "no layout is lower\n" : fmt::format("no layout is lower than {}\n", facts_.lower_bound.text()));
  }

  /// No parts, or none that are wanted or fit a container.
  Outcome empty() {
    packing::SolidLayout layout;
    if (StopOnInterrupt::wanted()) return {"interrupted before a first layout was found\n", kInterrupted};
    if (!problem_.conditions.empty() && problem_.items() > 0)
      throw Error(ErrorCode::kLimit, "no layout was found in which all conditions of pairs hold", options_.scene);
    layout.left_out = all_left_out(problem_.parts, "it is larger than every container");
    facts_.proven = true;
    write(layout);
    const bool wanted = problem_.items() > 0;
    return {options_.json ? io::layout_json(problem_, layout, facts_)
            : wanted      ? "no part fits a container\n"
                          : "there are no parts to pack\n",
            wanted ? kEmpty : kDone};
  }

  const Options& options_;
  Reporter& reporter_;
  packing::SolidProblem problem_;
  io::LayoutFacts facts_;
};

const char* kind_of(packing::SolidFault::Kind kind) {
  constexpr const char* kNames[] = {"overlap", "gap", "outside", "count", "containers", "condition"};
  return kNames[std::size_t(kind)];
}

std::string solid_verdict_text(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                               const packing::SolidVerdict& verdict) {
  std::string text =
      fmt::format("{}  {} items, height {}, density {:.4f} %\n", verdict.is_feasible() ? "feasible" : "not feasible",
                  layout.items.size(), layout.height.text(), 100 * verdict.density);
  for (std::size_t i = 0; i < std::min(kFaultsNamed, verdict.faults.size()); ++i)
    text += "  " + io::fault_text(problem, layout, verdict.faults[i]) + "\n";
  if (verdict.faults.size() > kFaultsNamed)
    text += fmt::format("  and {} more\n", verdict.faults.size() - kFaultsNamed);
  return text;
}

std::string solid_verdict_json(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                               const packing::SolidVerdict& verdict) {
  using Kind = packing::SolidFault::Kind;
  std::string faults;
  double deepest = 0;
  for (const packing::SolidFault& fault : verdict.faults) {
    if (fault.kind == Kind::kOverlap) deepest = std::max(deepest, fault.depth);
    const std::string first = fault.kind == Kind::kCount        ? problem.parts[fault.first].name
                              : fault.kind == Kind::kContainers ? problem.containers[fault.first].name
                                                                : io::item_name(problem, layout, fault.first);
    std::string of = fmt::format("\"{}\"", first);
    if (fault.kind <= Kind::kGap || fault.kind == Kind::kCondition)
      of += fmt::format(", \"{}\"", io::item_name(problem, layout, fault.second));
    faults += fmt::format("{}\n  {{\"kind\": \"{}\", \"of\": [{}], \"depth\": {}, \"near\": [{}, {}, {}]}}",
                          faults.empty() ? "" : ",", kind_of(fault.kind), of, fault.depth, fault.at[0], fault.at[1],
                          fault.at[2]);
  }
  return fmt::format(
      "{{\"findspace\": 1, \"verdict\": {{\"feasible\": {}, \"items\": {}, \"height\": \"{}\", \"used\": \"{}\", "
      "\"density\": {}, \"largest_overlap\": {}, \"faults\": [{}]}}}}\n",
      verdict.is_feasible(), layout.items.size(), layout.height.text(), verdict.used.text(), verdict.density, deepest,
      faults);
}

}  // namespace

Outcome run_pack_solids(const Options& options, const std::string& text, Reporter& reporter) {
  return SolidPacking(options, text, reporter).run();
}

Outcome run_verify_solids(const Options& options, const std::string& layout, const std::string& problem) {
  const packing::SolidProblem read = read_problem(options, problem, options.shapes[0]).problem;
  const packing::SolidLayout checked = io::read_solid_layout(layout, options.scene, read);
  const packing::SolidVerdict verdict = packing::verify(read, checked);
  return {(options.json ? solid_verdict_json : solid_verdict_text)(read, checked, verdict),
          verdict.is_feasible() ? kDone : kEmpty};
}

}  // namespace findspace::app
