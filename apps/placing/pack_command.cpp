// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include <findspace/error.h>
#include <fmt/format.h>

#include "common/commands.h"
#include "common/run_limits.h"
#include "common/session.h"
#include "common/stop_on_interrupt.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/read_solids.h"
#include "io/nesting/write_layout.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/box_search.h"
#include "packing/search/refined_search.h"
#include "placing/pack_solids.h"
#include "placing/packing_report.h"
#include "placing/stated_problem.h"

namespace findspace::app {
namespace {

class Packing {
 public:
  Packing(const Options& options, const StatedProblem& stated, Reporter& reporter)
      : options_(options), reporter_(reporter) {
    check_outputs(options, {".json", ".svg", ".dxf"});
    io::UnscaledProblem problem = read_stated(stated, options);
    for (const std::string& note : problem.notes) reporter_.note(note);
    problem_ = std::move(problem).on_grid(stated.name);
    if (!problem_.on_sheets() && !problem_.box) bound_ = packing::lower_bound(problem_);
  }

  Outcome run() {
    auto search = search_options<packing::Layout>(options_);
    facts_.seed = search.seed;
    facts_.threads = search.threads;
    packing::Layout start;
    if (options_.start) {
      start = start_layout(problem_, *options_.start, options_.input_limit);
      search.start = &start;
    }
    const packing::SearchEvents events{[&](const auto& layout, const auto& state) { keep(layout, state); },
                                       [&](const auto& state) { show(state); }};
    std::optional<packing::Layout> best;
    {
      const StopOnInterrupt interrupt;
      best = (problem_.box ? packing::search_box : packing::search_refined)(problem_, search, events,
                                                                            StopOnInterrupt::wanted());
    }
    if (!best) return empty();
    return {answer(*best), StopOnInterrupt::wanted() ? kInterrupted : kDone};
  }

 private:
  /// Every better layout is in its files at once.
  void keep(const packing::Layout& layout, const packing::SearchState& state) {
    facts_.seconds = state.seconds;
    facts_.density = state.density;
    facts_.lower_bound = bound_;
    facts_.proven = packing::verify(problem_, layout).feasible();
    facts_.remnant = packing::largest_remnant(problem_, layout);
    write(layout);
    answer_at_the_end(is_printed(options_) ? answer(layout) : "");
    if (!options_.quiet) reporter_.note(better_text(state, "length"));
  }

  void show(const packing::SearchState& state) { reporter_.stage(progress_text(state, "length")); }

  void write(const packing::Layout& layout) const {
    write_outputs(options_, {{".json", [&] { return json(layout); }},
                             {".svg", [&] { return io::layout_svg(problem_, layout, facts_); }},
                             {".dxf", [&] { return io::layout_dxf(problem_, layout, options_.dxf); }}});
  }

  std::string json(const packing::Layout& layout) const { return io::layout_json(problem_, layout, facts_); }

  std::string answer(const packing::Layout& layout) const { return options_.json ? json(layout) : summary(layout); }

  std::string summary(const packing::Layout& layout) const {
    std::string text = fmt::format("length {}", layout.length.text());
    if (problem_.on_sheets())
      text = fmt::format("{} sheet{}, of the last {} used", layout.sheets.size(), layout.sheets.size() == 1 ? "" : "s",
                         layout.length.text());
    if (problem_.box) text = fmt::format("{} wide, {} high", layout.length.text(), layout.height.text());
    text += fmt::format(", density {:.4f} %, {} parts, proved free of overlaps\n", 100 * facts_.density,
                        layout.items.size());
    if (!problem_.on_sheets() && !problem_.box) text += fmt::format("no layout is shorter than {}\n", bound_.text());
    if (const auto& left = facts_.remnant)
      text += fmt::format("the largest free rectangle of the last sheet: {} x {} at ({}, {})\n", left->width.text(),
                          left->height.text(), left->x.text(), left->y.text());
    return text + left_out_text(problem_.parts, layout.left_out);
  }

  /// No parts, none that are wanted or fit a sheet, or no layout in which all conditions hold.
  Outcome empty() {
    packing::Layout layout;
    if (StopOnInterrupt::wanted()) return {"interrupted before a first layout was found\n", kInterrupted};
    if (!problem_.on_sheets() && problem_.items() > 0)
      throw Error(ErrorCode::kLimit, "no layout was found in which all conditions of pairs hold", options_.scene);
    layout.left_out = all_left_out(problem_.parts, "it is larger than every sheet");
    facts_.proven = true;
    write(layout);
    const bool wanted = problem_.items() > 0;
    return {options_.json ? json(layout)
            : wanted      ? "no part fits a sheet\n"
                          : "there are no parts to pack\n",
            wanted ? kEmpty : kDone};
  }

  const Options& options_;
  Reporter& reporter_;
  packing::Problem problem_;
  packing::Fraction bound_;
  io::LayoutFacts facts_;
};

}  // namespace

Outcome run_pack(const Options& options, Reporter& reporter) {
  std::vector<std::string> words{options.scene};
  words.insert(words.end(), options.shapes.begin(), options.shapes.end());
  const StatedProblem stated = stated_problem(words, options);
  if (io::is_solid_problem(stated.text, stated.name)) return run_pack_solids(options, stated.text, reporter);
  return Packing(options, stated, reporter).run();
}

}  // namespace findspace::app
