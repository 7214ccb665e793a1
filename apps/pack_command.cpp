// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include <findspace/error.h>
#include <fmt/format.h>
#include <signal.h>

#include <atomic>
#include <thread>

#include "commands.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/write_layout.h"
#include "io/text/read_text.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/strip_search.h"
#include "packing_report.h"
#include "session.h"

namespace findspace::app {
namespace {

std::atomic<bool> stop_wanted = false;

extern "C" void on_stop(int) { stop_wanted = true; }

/// While it lives Ctrl-C and a polite end of the process end the search, and the best layout is kept.
class StopOnInterrupt {
 public:
  StopOnInterrupt() {
    struct sigaction action {};
    action.sa_handler = on_stop;
    sigaction(SIGINT, &action, &interrupt_);
    sigaction(SIGTERM, &action, &terminate_);
  }
  ~StopOnInterrupt() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
  }
  StopOnInterrupt(const StopOnInterrupt&) = delete;
  StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

 private:
  struct sigaction interrupt_ {
  }, terminate_{};
};

packing::Layout start_layout(const packing::Problem& problem, const Options& options) {
  const std::filesystem::path& path = *options.start;
  const std::string text = io::read_text(path, options.input_limit);
  packing::Layout layout;
  if (path.extension() == ".svg") {
    io::ProblemAndLayout read = io::read_sparrow_svg(text, path.string());
    layout = std::move(read.layout);
    for (packing::Placed& item : layout.items) {
      const std::string& name = read.problem.parts[item.part].name;
      const auto same = [&](const packing::Part& part) { return part.name == name; };
      const auto found = std::find_if(problem.parts.begin(), problem.parts.end(), same);
      if (found == problem.parts.end())
        throw Error(ErrorCode::kBadValue, fmt::format("no part '{}'", name), path.string());
      item.part = std::size_t(found - problem.parts.begin());
    }
  } else {
    layout = io::read_layout(text, path.string(), problem);
  }
  std::vector<int> missing;
  for (const packing::Part& part : problem.parts) missing.push_back(part.demand);
  for (const packing::Placed& item : layout.items) --missing[item.part];
  if (std::any_of(missing.begin(), missing.end(), [](int count) { return count != 0; }))
    throw Error(ErrorCode::kBadValue, "the layout to start with has other parts than the problem", path.string());
  return layout;
}

class Packing {
 public:
  Packing(const Options& options, Reporter& reporter) : options_(options), reporter_(reporter) {
    check_outputs(options, {".json", ".svg"});
    problem_ =
        io::read_nesting(io::read_text(options.scene, options.input_limit), options.scene, nesting_wishes(options));
    bound_ = packing::lower_bound(problem_);
  }

  Outcome run() {
    packing::SearchOptions search;
    search.seed = options_.seed;
    search.threads = options_.threads > 0 ? options_.threads : std::max(1u, std::thread::hardware_concurrency());
    search.seconds = options_.time_limit;
    search.work = options_.work * 1000000;
    facts_.seed = search.seed;
    facts_.threads = search.threads;
    packing::Layout start;
    if (options_.start) {
      start = start_layout(problem_, options_);
      search.start = &start;
    }
    const packing::SearchEvents events{[&](const auto& layout, const auto& state) { keep(layout, state); },
                                       [&](const auto& state) { show(state); }};
    std::optional<packing::Layout> best;
    {
      const StopOnInterrupt interrupt;
      best = packing::search_strip(problem_, search, events, stop_wanted);
    }
    if (!best) return empty();
    return {options_.json ? json(*best) : summary(*best), stop_wanted ? kInterrupted : kDone};
  }

 private:
  /// Every better layout is in its files at once.
  void keep(const packing::Layout& layout, const packing::SearchState& state) {
    facts_.seconds = state.seconds;
    facts_.density = state.density;
    facts_.lower_bound = bound_;
    facts_.proven = packing::verify(problem_, layout).feasible();
    write(layout);
    if (!options_.quiet)
      reporter_.note(
          fmt::format("{:8.2f} s  processor {:8.2f} s  length {:.6g}  density {:.3f} %", state.seconds, state.processor,
                      state.length, 100 * state.density));
  }

  void show(const packing::SearchState& state) {
    reporter_.stage(fmt::format("{:.0f} s  length {:.6g}  density {:.3f} %  overlap left {:.3g}  better {:.0f} s ago",
                                state.seconds, state.length, 100 * state.density, state.overlap, state.since_better));
  }

  void write(const packing::Layout& layout) const {
    write_outputs(options_, {{".json", [&] { return json(layout); }},
                             {".svg", [&] { return io::layout_svg(problem_, layout, facts_); }}});
  }

  std::string json(const packing::Layout& layout) const { return io::layout_json(problem_, layout, facts_); }

  std::string summary(const packing::Layout& layout) const {
    return fmt::format("length {}, density {:.4f} %, {} parts, proved free of overlaps\nno layout is shorter than {}\n",
                       layout.length.text(), 100 * facts_.density, layout.items.size(), bound_.text());
  }

  /// No parts, or none that are wanted.
  Outcome empty() {
    const packing::Layout layout;
    facts_.proven = true;
    write(layout);
    return {options_.json ? json(layout) : "there are no parts to pack\n", kDone};
  }

  const Options& options_;
  Reporter& reporter_;
  packing::Problem problem_;
  packing::Fraction bound_;
  io::LayoutFacts facts_;
};

}  // namespace

Outcome run_pack(const Options& options, Reporter& reporter) { return Packing(options, reporter).run(); }

}  // namespace findspace::app
