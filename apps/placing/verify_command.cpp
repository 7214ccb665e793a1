// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include <findspace/error.h>
#include <findspace/packing.h>
#include <findspace/solid_packing.h>
#include <findspace/text.h>

#include "common/commands.h"
#include "placing/packing_report.h"
#include "placing/stated_problem.h"

namespace findspace::app {
namespace {

template <class Problem, class Layout>
Outcome verdict_on(const Problem& packing, const Layout& layout, bool as_json) {
  const PackVerdict verdict = packing.verdict(layout);
  const auto make = as_json ? verdict_json : verdict_text;
  return {make(layout.items.size(), size_of(layout), verdict), verdict.feasible() ? kDone : kEmpty};
}

/// Without a problem: an SVG of sparrow has outlines of its own.
Outcome verdict_alone(const std::string& text, const Options& options, bool drawn) {
  if (!drawn) throw Error(ErrorCode::kUsage, "a layout as JSON needs its problem: findspace verify LAYOUT PROBLEM");
  if (options.height || options.gap != "0" || options.edge != "0")
    throw Error(ErrorCode::kUsage, "--gap, --edge and --height need a problem: findspace verify LAYOUT PROBLEM");
  const auto [packing, layout] = Packing::sparrow(text, options.scene);
  return verdict_on(packing, layout, options.json);
}

}  // namespace

Outcome run_verify(const Options& options, Reporter&) {
  const std::string text = read_text(options.scene, options.input_limit);
  const bool drawn = std::filesystem::path(options.scene).extension() == ".svg";
  if (options.shapes.empty()) return verdict_alone(text, options, drawn);
  const StatedProblem stated = stated_problem(options.shapes, options);
  if (SolidPacking::is_stated_in(stated.text, stated.name)) {
    if (drawn) throw Error(ErrorCode::kUsage, "an SVG of sparrow is a layout of the plane", options.scene);
    const SolidPacking packing = stated_solids(stated, options);
    return verdict_on(packing, packing.layout(text, options.scene), options.json);
  }
  const Packing packing = stated_packing(stated, options);
  const PackLayout layout = drawn ? Packing::sparrow(text, options.scene).second : packing.layout(text, options.scene);
  return verdict_on(packing, layout, options.json);
}

}  // namespace findspace::app
