// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/session.h"
#include "in_plane/orientation_command.h"
#include "in_plane/rotation_command.h"

namespace findspace::app {

namespace {

Outcome explain_positions(const Session& session) {
  const Options& options = session.options();
  const Formula where = session.public_where();
  const World world = session.public_world();
  session.reporter().stage("explaining");
  const Explanation found = options.at && session.in_space() ? world.explain(where, *asked_point_in_space(session))
                                                             : world.explain(where, asked_point(session));
  write_outputs(options, {{".json", [&] { return found.json; }}});
  return {options.json ? found.json : found.text, (found.here ? found.here->holds : found.feasible) ? kDone : kEmpty};
}

}  // namespace

Outcome run_explain(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  check_outputs(options, {".json"});
  if (session.in_space()) {
    session.require_positions_in_space(false, true);
    return at_orientations(session, explain_positions);
  }
  refuse_orientation(options);
  if (options.angle || asks_for_poses(session)) return explain_poses(session);
  session.require_positions(false);
  return explain_positions(session);
}

}  // namespace findspace::app
