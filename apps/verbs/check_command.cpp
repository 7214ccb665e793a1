// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/session.h"
#include "common/told.h"
#include "findspace/error.h"
#include "findspace/vocabulary.h"
#include "in_plane/board_check.h"
#include "in_plane/orientation_command.h"

namespace findspace::app {
namespace {

using Kind = Scene::Free::Kind;

/// The words of the distances that are looked at; none: all. Throws Error(kUsage) for an unknown --only.
std::vector<std::string> wanted_words(const Session& session) {
  const Options& options = session.options();
  if (!options.only.empty()) {
    std::vector<std::string> known;
    for (DistanceWord& row : distance_words()) known.push_back(std::move(row.word));
    if (std::find(known.begin(), known.end(), options.only) != known.end()) return {options.only};
    const std::string near = nearest_word(options.only, known);
    std::string hint = near.empty() ? "; the distances are" : "; did you mean '" + near + "'?";
    for (std::size_t k = 0; near.empty() && k < known.size(); ++k) hint += (k > 0 ? ", " : " ") + known[k];
    throw Error(ErrorCode::kUsage, "--only " + options.only + ": there is no such distance" + hint);
  }
  const bool file = std::any_of(options.outputs.begin(), options.outputs.end(),
                                [](const auto& path) { return path.extension() == ".json"; });
  return options.all || options.json || file ? std::vector<std::string>{} : usual_distance_words();
}

/// Where a check is asked for; refuses what it does not write.
Pose checked_pose(const Session& session) {
  check_outputs(session.options(), session.in_space() ? std::vector<std::string>{".json", ".svg"}
                                                      : std::vector<std::string>{".svg", ".json"});
  Pose pose = asked_pose(session);
  if (session.scene().free().kind == Kind::kTime && !pose.time)
    throw Error(ErrorCode::kUsage, "with \"free\": \"time\" check wants the instant too: --time t");
  return pose;
}

}  // namespace

Outcome run_check(const Options& options, Reporter& reporter) {
  if (is_board(options.scene)) refuse_orientation(options);
  if (is_board(options.scene) && options.move.empty()) return check_board(options, reporter);
  if (!options.at && !options.angle && !options.orientation)
    throw Error(ErrorCode::kUsage, "check wants a position: --at x,y (or x,y,z)");
  Session session(options, reporter);
  if (session.in_space())
    return at_orientations(session, [](const Session& s) { return told(s, s.scene().check(checked_pose(s))); });
  refuse_orientation(options);
  const Pose pose = checked_pose(session);
  return told(session, session.take().check(pose));
}

Outcome run_measure(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  const auto measure = [](const Session& s) {
    check_outputs(s.options(),
                  s.in_space() ? std::vector<std::string>{".json", ".svg"} : std::vector<std::string>{".svg", ".json"});
    return told(s, s.scene().measure(asked_pose(s), wanted_words(s)));
  };
  if (session.in_space()) return at_orientations(session, measure);
  refuse_orientation(options);
  return measure(session);
}

}  // namespace findspace::app
