// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/session.h"

namespace findspace::app {

Outcome run_explain(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  if (session.in_space())
    throw Error(ErrorCode::kUnsupported, "explain answers in the plane, not for 3D scenes", session.scene().file);
  check_outputs(options, {".json"});
  session.require_positions(false);
  const Formula where = session.public_where();
  const World world = session.public_world();
  const std::optional<Point> at = asked_point(session);
  reporter.stage("explaining");
  const Explanation found = world.explain(where, at);
  write_outputs(options, {{".json", [&] { return found.json; }}});
  return {options.json ? found.json : found.text, (found.here ? found.here->holds : found.feasible) ? kDone : kEmpty};
}

}  // namespace findspace::app
