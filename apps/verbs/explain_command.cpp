// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/session.h"
#include "common/told.h"
#include "findspace/error.h"
#include "in_plane/orientation_command.h"

namespace findspace::app {

Outcome run_explain(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  check_outputs(options, {".json"});
  const auto explain = [](const Session& s) { return told(s, s.scene().explain(asked_pose(s))); };
  if (session.in_space()) return at_orientations(session, explain);
  refuse_orientation(options);
  if (options.at && !options.angle && session.scene().free().kind == Scene::Free::Kind::kPose)
    throw Error(ErrorCode::kUsage, "--at is for one angle: --angle says which", session.scene().name());
  return explain(session);
}

}  // namespace findspace::app
