// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/session.h"
#include "io/write/write_explanation.h"

namespace findspace::app {

Outcome run_explain(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  if (session.in_space())
    throw Error(ErrorCode::kUnsupported, "explain answers in the plane, not for 3D scenes", session.scene().file);
  check_outputs(options, {".json"});
  session.require_positions(false);
  const formula::Formula formula = session.where();
  const formula::Solver solver(session.world());
  reporter.stage("explaining");
  const formula::Explanation explanation = formula::explain(solver, formula);
  std::optional<formula::PositionExplanation> here;
  const exact::RealPoint at = asked_position(session);
  if (options.at) here = formula::explain_at(solver, formula, at);
  const io::ExplanationReport report{formula, explanation,         here ? &*here : nullptr,
                                     at,      solver.world().step, session.unit()};
  const auto json = [&] { return io::explanation_json(report); };
  write_outputs(options, {{".json", json}});
  const bool yes = here ? here->check.holds : explanation.feasible;
  return {options.json ? json() : io::explanation_text(report), yes ? kDone : kEmpty};
}

}  // namespace findspace::app
