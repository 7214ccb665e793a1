// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include <findspace/error.h>

#include "common/commands.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/read_solids.h"
#include "io/text/read_text.h"
#include "packing/proof/verify.h"
#include "placing/pack_solids.h"
#include "placing/packing_report.h"
#include "placing/stated_problem.h"

namespace findspace::app {
namespace {

io::ProblemAndLayout read_in_plane(const Options& options, const std::string& text, const StatedProblem& stated) {
  packing::Problem problem = read_stated(stated, options).on_grid(stated.name);
  packing::Layout layout = io::read_layout(text, options.scene, problem);
  return {std::move(problem), std::move(layout)};
}

Outcome verdict_on(const io::ProblemAndLayout& read, bool as_json) {
  const packing::Verdict verdict = packing::verify(read.problem, read.layout);
  const auto make = as_json ? verdict_json : verdict_text;
  return {make(read.problem, read.layout, verdict), verdict.feasible() ? kDone : kEmpty};
}

}  // namespace

Outcome run_verify(const Options& options, Reporter&) {
  const std::string text = io::read_text(options.scene, options.input_limit);
  if (std::filesystem::path(options.scene).extension() == ".svg")
    return verdict_on(io::read_sparrow_svg(text, options.scene), options.json);
  if (options.shapes.empty())
    throw Error(ErrorCode::kUsage, "a layout as JSON needs its problem: findspace verify LAYOUT PROBLEM");
  const StatedProblem problem = stated_problem(options.shapes, options);
  if (io::is_solid_problem(problem.text, problem.name)) return run_verify_solids(options, text, problem.text);
  return verdict_on(read_in_plane(options, text, problem), options.json);
}

}  // namespace findspace::app
