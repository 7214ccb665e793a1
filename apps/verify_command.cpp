// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include <findspace/error.h>

#include "commands.h"
#include "io/nesting/read_nesting.h"
#include "io/text/read_text.h"
#include "packing/proof/verify.h"
#include "packing_report.h"

namespace findspace::app {
namespace {

io::ProblemAndLayout read_layout_of(const Options& options) {
  const std::string text = io::read_text(options.scene, options.input_limit);
  if (std::filesystem::path(options.scene).extension() == ".svg") return io::read_sparrow_svg(text, options.scene);
  if (options.shapes.empty())
    throw Error(ErrorCode::kUsage, "a layout as JSON needs its problem: findspace verify LAYOUT PROBLEM");
  packing::Problem problem = io::read_nesting(io::read_text(options.shapes[0], options.input_limit), options.shapes[0],
                                              nesting_wishes(options));
  packing::Layout layout = io::read_layout(text, options.scene, problem);
  return {std::move(problem), std::move(layout)};
}

}  // namespace

Outcome run_verify(const Options& options, Reporter&) {
  const io::ProblemAndLayout read = read_layout_of(options);
  const packing::Verdict verdict = packing::verify(read.problem, read.layout);
  const auto make = options.json ? verdict_json : verdict_text;
  return {make(read.problem, read.layout, verdict), verdict.feasible() ? kDone : kEmpty};
}

}  // namespace findspace::app
