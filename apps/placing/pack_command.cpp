// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `pack`: one run for the plane and for space, with what the two say differently.

#include <findspace/error.h>
#include <findspace/packing.h>
#include <findspace/solid_packing.h>
#include <fmt/format.h>

#include "common/commands.h"
#include "common/outputs.h"
#include "common/run_limits.h"
#include "common/stop_on_interrupt.h"
#include "placing/packing_report.h"
#include "placing/stated_problem.h"

namespace findspace::app {
namespace {

/// How near the number of sheets or containers is to what no layout is below.
std::string fewest(std::size_t used, const Number& bound, const char* holder) {
  return bound.text() == std::to_string(used)
             ? fmt::format("no layout of all parts uses fewer {}s\n", holder)
             : fmt::format("no layout of all parts uses fewer than {}\n", bound.text());
}

/// And a size to what no layout is below; `word`: what none is. `reached`: the two are the same number, exactly.
std::string least(const char* word, double size, const Number& bound, bool reached) {
  if (reached) return fmt::format("no {}\n", word);
  return fmt::format("no {} than {}, {:.2f} % below that\n", word, bound.text(), 100 * (1 - bound.value() / size));
}

/// What differs: words, files, and when no layout at all is an error.
struct Plane {
  using Problem = Packing;
  using Layout = PackLayout;
  static constexpr const char *kSize = "length", *kHolder = "sheet";

  static bool has_containers(const PackProblem& problem) { return !problem.sheets.empty(); }
  static bool may_lack_a_layout(const PackProblem& problem) { return problem.sheets.empty(); }

  static Writers writers(const Packing& packing, const PackLayout& layout, const Options& options) {
    return {{".json", [&] { return packing.json(layout); }},
            {".svg", [&] { return packing.svg(layout); }},
            {".dxf", [&] { return packing.dxf(layout, options.dxf); }}};
  }
  static std::string summary(const Packing& packing, const PackLayout& layout) {
    const PackProblem& problem = packing.problem();
    const std::string length = layout.length.text();
    std::string text = fmt::format("length {}", length);
    if (has_containers(problem))
      text = fmt::format("{} sheet{}, of the last {} used", layout.sheets.size(), layout.sheets.size() == 1 ? "" : "s",
                         length);
    if (problem.box) text = fmt::format("{} wide, {} high", length, layout.height.text());
    text += fmt::format(", density {:.4f} %, {} parts, proved free of overlaps\n", 100 * layout.density,
                        layout.items.size());
    if (has_containers(problem) && layout.left_out.empty())
      text += fewest(layout.sheets.size(), packing.lower_bound(), kHolder);
    const double size = layout.length.value() * (problem.box ? layout.height.value() : 1);
    if (!has_containers(problem))
      text += least(problem.box ? "box has a smaller area" : "layout is shorter", size, packing.lower_bound(),
                    !problem.box && length == packing.lower_bound().text());
    if (const auto& left = layout.remnant)
      text += fmt::format("the largest free rectangle of the last sheet: {} x {} at ({}, {})\n", left->width.text(),
                          left->height.text(), left->x.text(), left->y.text());
    return text;
  }
  static Number bound(const Packing& packing, const PackLayout&) { return packing.lower_bound(); }
  static PackLayout start(const Packing& packing, const Options& options) {
    return start_layout(packing, *options.start, options.input_limit);
  }
};

struct Space {
  using Problem = SolidPacking;
  using Layout = SolidPackLayout;
  static constexpr const char *kSize = "height", *kHolder = "container";

  /// In containers a part that fits one alone is a layout.
  static bool may_lack_a_layout(const SolidPackProblem& problem) {
    return problem.containers.empty() &&
           (!problem.where.empty() || !problem.conditions.empty() || !problem.groups.empty());
  }
  static Writers writers(const SolidPacking& packing, const SolidPackLayout& layout, const Options&) {
    Writers result{{".json", [&] { return packing.json(layout); }}, {".svg", [&] { return packing.svg(layout); }}};
    for (const char* ending : {".obj", ".off", ".stl", ".ply", ".glb", ".3mf", ".step"})
      result[ending] = [&packing, &layout, ending] { return packing.file(layout, ending); };
    return result;
  }
  static std::string summary(const SolidPacking& packing, const SolidPackLayout& layout) {
    const bool contained = !packing.problem().containers.empty();
    const std::string height = layout.height.text();
    std::string text = fmt::format("height {}", height);
    if (contained)
      text = fmt::format("{} container{}, of the last {} used", layout.containers.size(),
                         layout.containers.size() == 1 ? "" : "s", height);
    text += fmt::format(", density {:.4f} %, {} parts, proved free of overlaps\n", 100 * layout.density,
                        layout.items.size());
    if (contained)
      return layout.left_out.empty() ? text + fewest(layout.containers.size(), layout.lower_bound, kHolder) : text;
    return text +
           least("layout is lower", layout.height.value(), layout.lower_bound, height == layout.lower_bound.text());
  }
  static Number bound(const SolidPacking&, const SolidPackLayout& layout) { return layout.lower_bound; }
  static SolidPackLayout start(const SolidPacking& packing, const Options& options) {
    return start_layout(packing, *options.start, options.input_limit);
  }
};

template <class Kind>
class PackRun {
 public:
  using Layout = typename Kind::Layout;

  PackRun(const Options& options, typename Kind::Problem packing, Reporter& reporter)
      : options_(options), reporter_(reporter), packing_(std::move(packing)) {
    for (const std::string& note : packing_.notes()) reporter_.note(note);
  }

  Outcome run() {
    PackSearch<Layout> search;
    if (options_.start) search.start = Kind::start(packing_, options_);
    search.better = [&](const Layout& layout, const PackProgress& state) { keep(layout, state); };
    search.progress = [&](const PackProgress& state) { reporter_.stage(progress_text(state, Kind::kSize)); };
    search.peers = peers_of(options_);
    std::optional<Layout> best;
    {
      const StopOnInterrupt interrupt;
      best = packing_.search(search_options(options_), search);
    }
    if (!best || best->items.empty()) return empty(best);
    if (Kind::bound(packing_, *best).text() != bound_) write(*best);
    return {answer(*best), was_stopped() ? kInterrupted : kDone};
  }

 private:
  static bool was_stopped() { return StopOnInterrupt::wanted().requested(); }

  /// Every better layout is in its files at once.
  void keep(const Layout& layout, const PackProgress& state) {
    bound_ = Kind::bound(packing_, layout).text();
    write(layout);
    answer_at_the_end(is_printed(options_) ? answer(layout) : "");
    if (!options_.quiet) reporter_.note(better_text(state, Kind::kSize));
  }

  void write(const Layout& layout) const { write_outputs(options_, Kind::writers(packing_, layout, options_)); }

  std::string answer(const Layout& layout) const {
    if (options_.json) return packing_.json(layout);
    std::string text = Kind::summary(packing_, layout);
    for (const LeftOutPart& out : layout.left_out)
      text += fmt::format("left out: {} of {}: {}\n", out.copies, out.part, out.why);
    return text;
  }

  /// No parts, none that are wanted or fit, or no layout in which all conditions hold. `found`: without items, where
  /// some would fit.
  Outcome empty(const std::optional<Layout>& found) {
    if (was_stopped()) return {"interrupted before a first layout was found\n", kInterrupted};
    const bool wanted = packing_.copies() > 0;
    if (wanted && !found && Kind::may_lack_a_layout(packing_.problem()))
      throw Error(ErrorCode::kLimit, "no layout was found in which all conditions of pairs hold", options_.scene);
    const Layout layout = found ? *found : all_too_large();
    write(layout);
    return {options_.json ? packing_.json(layout)
            : !wanted     ? "there are no parts to pack\n"
            : found       ? fmt::format("no place was found on a {} for any part\n", Kind::kHolder)
                          : fmt::format("no part fits a {}\n", Kind::kHolder),
            wanted ? kEmpty : kDone};
  }

  Layout all_too_large() const {
    Layout layout;
    for (const auto& part : packing_.problem().parts)
      if (part.count > 0)
        layout.left_out.push_back({part.name, part.count, fmt::format("it is larger than every {}", Kind::kHolder)});
    return layout;
  }

  const Options& options_;
  Reporter& reporter_;
  typename Kind::Problem packing_;
  std::string bound_;  // of what was written last
};

}  // namespace

Outcome run_pack(const Options& options, Reporter& reporter) {
  std::vector<std::string> words{options.scene};
  words.insert(words.end(), options.shapes.begin(), options.shapes.end());
  const StatedProblem stated = stated_problem(words, options);
  if (SolidPacking::is_stated_in(stated.text, stated.name)) {
    check_outputs(options, {".json", ".svg", ".obj", ".off", ".stl", ".ply", ".glb", ".3mf", ".step"});
    return PackRun<Space>(options, stated_solids(stated, options), reporter).run();
  }
  check_outputs(options, {".json", ".svg", ".dxf"});
  return PackRun<Plane>(options, stated_packing(stated, options), reporter).run();
}

}  // namespace findspace::app
