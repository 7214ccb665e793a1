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

}  // namespace

Outcome run_verify(const Options& options, Reporter&) {
  const std::string text = read_text(options.scene, options.input_limit);
  if (std::filesystem::path(options.scene).extension() == ".svg") {
    const auto [packing, layout] = Packing::sparrow(text, options.scene);
    return verdict_on(packing, layout, options.json);
  }
  if (options.shapes.empty())
    throw Error(ErrorCode::kUsage, "a layout as JSON needs its problem: findspace verify LAYOUT PROBLEM");
  const StatedProblem stated = stated_problem(options.shapes, options);
  if (SolidPacking::is_stated_in(stated.text, stated.name)) {
    const SolidPacking packing = stated_solids(stated, options);
    return verdict_on(packing, packing.layout(text, options.scene), options.json);
  }
  const Packing packing = stated_packing(stated, options);
  return verdict_on(packing, packing.layout(text, options.scene), options.json);
}

}  // namespace findspace::app
