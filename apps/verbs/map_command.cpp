// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <utility>

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/line_choice.h"
#include "common/session.h"
#include "common/told.h"
#include "findspace/error.h"
#include "in_plane/orientation_command.h"

namespace findspace::app {
namespace {

using Kind = Scene::Free::Kind;

/// Positions in space, on lines where they are asked for or there is no exact form.
Outcome map_positions(const Session& session) {
  const Options& options = session.options();
  SetInSpace set = asked_in_space(options);
  MapQuestion question;
  question.apply = options.apply;
  question.before = "--";
  question.lines = std::move(set.lines);
  question.listed = set.listed;
  question.surface = set.surface;
  const Answer answer = session.scene().map(question);
  session.reporter().stage("writing");
  return told(session, answer);
}

Outcome map_in_space(const Session& session) {
  const Options& options = session.options();
  const bool line = session.scene().free().kind == Kind::kLine;
  if (line) {
    refuse_lines(options, "for maps of space, not of a line");
    if (options.orientation)
      throw Error(ErrorCode::kUsage, "--orientation is for maps of positions and of poses, not of a line");
    check_outputs(options, {".json"});
    if (!options.apply.empty()) throw Error(ErrorCode::kUsage, "--apply is for maps of space, not of a line");
    const Answer answer = session.scene().map();
    return told(session, answer);
  }
  return at_orientations(session, map_positions);
}

std::vector<std::string> formats_of(Kind free) {
  if (free == Kind::kPose) return {".json", ".html", ".svg"};
  if (free == Kind::kAngle) return {".json", ".svg"};
  if (free == Kind::kPosition) return {".svg", ".dxf", ".wkt", ".json"};
  return {".json"};
}

void refuse_apply(const Options& options, Kind free) {
  if (options.apply.empty() || free == Kind::kPosition) return;
  const bool angles = free == Kind::kPose || free == Kind::kAngle;
  throw Error(ErrorCode::kUsage, std::string("--apply is for maps of the plane, not ") +
                                     (angles ? "for those over angles" : "of a line or of time"));
}

}  // namespace

Outcome run_map(const Options& options, Reporter& reporter) {
  Session session(options, reporter);
  const Kind free = session.scene().free().kind;
  if (!session.in_space()) refuse_orientation(options);
  if (options.at && free != Kind::kTime && free != Kind::kAngle)
    throw Error(ErrorCode::kUsage, "--at is for a map of time or of angles: a map of positions has all of them");
  if (session.in_space()) return map_in_space(session);
  refuse_lines(options, "for maps of 3D scenes");
  check_outputs(options, formats_of(free));
  refuse_apply(options, free);
  const bool drawn = std::any_of(options.outputs.begin(), options.outputs.end(),
                                 [](const auto& path) { return path.extension() == ".svg"; });
  MapQuestion question{asked_pose(session), options.apply, drawn};
  question.before = "--";
  const Answer answer = session.take().map(question);
  reporter.stage("writing");
  return told(session, answer);
}

}  // namespace findspace::app
