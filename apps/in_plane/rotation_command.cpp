// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "in_plane/rotation_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/asked_numbers.h"
#include "formula/planar/rotation_bounds.h"
#include "io/draw/draw_layout.h"
#include "io/report/position_report.h"
#include "io/write/draw_rotations.h"
#include "io/write/write_json.h"
#include "io/write/write_position.h"
#include "io/write/write_summary.h"
#include "io/write/write_witness.h"
#include "plane/query/measure_cells_twofold.h"
#include "report/position_picture.h"
#include "report/scenery.h"

namespace findspace::app {
namespace {

using Kind = io::Free::Kind;

bool rotations(const io::Free& free) { return free.kind == Kind::kAngle || free.kind == Kind::kPose; }

exact::RealPoint about(const Session& session) {
  const io::GridPosition& p = session.scene().free.about;
  return {exact::Real(p[0]) * session.step(), exact::Real(p[1]) * session.step()};
}

void require_plane(const Session& session) {
  const io::Scene& scene = session.scene();
  if (scene.dimension != 2)
    throw Error(ErrorCode::kUnsupported, "rotations of shapes in space are not computed by this version", scene.file);
  if (scene.motion.given())
    throw Error(ErrorCode::kUnsupported, "an angle in a scene with \"motion\" is not computed", scene.file);
  if (scene.moving.empty())
    throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", scene.file);
}

void say_rounding(const Session& session, const plane::Rounding& rounding) {
  if (rounding.points == 0) return;
  session.reporter().note(
      fmt::format("{} vertices of the rotated shape were put on the grid, moved by at most {:.2g} {}", rounding.points,
                  rounding.largest * session.scene().grid.step_size(), session.unit()));
}

std::string angles_text(const std::vector<io::DegreeInterval>& angles) {
  std::string out;
  for (const io::DegreeInterval& i : angles) {
    if (i.from == i.to)
      out += fmt::format("  {} alone\n", io::shown(i.from));
    else if (i.to - i.from >= 360 && i.from_in)
      out += "  all\n";
    else
      out +=
          fmt::format("  {}{}, {}{}\n", i.from_in ? "[" : "(", io::shown(i.from), io::shown(i.to), i.to_in ? "]" : ")");
  }
  return out;
}

/// `outer` may be null.
std::string rotations_text(const Session& session, const std::vector<io::DegreeInterval>& angles,
                           const plane::RotationMap* outer) {
  std::string out = fmt::format("Angles of {}, in degrees\n", session.scene().moving_text());
  const std::string possible = outer != nullptr ? angles_text(io::degree_intervals(*outer)) : "";
  out += !angles.empty() ? angles_text(angles) : possible.empty() ? "  none: proven empty\n" : "  none certain\n";
  if (!possible.empty()) out += "possible\n" + possible;
  return out;
}

/// The moving shapes as they stand at the ends of the intervals, a few of them.
struct Station {
  double degrees;
  formula::World world;
};

std::vector<Station> stations(const formula::World& world, const exact::RealPoint& about,
                              const std::vector<io::DegreeInterval>& angles) {
  constexpr std::size_t kMost = 6;
  std::vector<double> ends;
  for (const io::DegreeInterval& i : angles) {
    ends.push_back(i.from);
    if (i.to != i.from && i.to - i.from < 360) ends.push_back(i.to);
  }
  std::erase(ends, 0.0);  // as it is drawn
  if (ends.size() > kMost) ends.resize(kMost);
  std::vector<Station> out;
  plane::Rounding rounding;
  const exact::RealPoint centre{about.x / world.step, about.y / world.step};
  for (const double d : ends)
    out.push_back({d, formula::rotated_world(world, centre, exact::Real::from_double(d), rounding)});
  return out;
}

std::string picture(const Session& session, const formula::World& world, const formula::Formula& formula,
                    const exact::RealPoint& at, const std::vector<io::DegreeInterval>& angles) {
  io::Picture p;
  p.title = fmt::format("Angles of {}{}", session.scene().moving_text(), angles.empty() ? ": none" : "");
  p.subtitle = session.scene().where.text;
  p.of_positions = false;
  p.position = {plane::Twofold(at.x).value(), plane::Twofold(at.y).value()};
  add_scenery(session, p, world, &formula);
  const auto shown = stations(world, about(session), angles);
  for (const Station& w : shown) {
    for (const io::NamedRegion& r : p.moving) {
      p.rotated.push_back({fmt::format("{}°", io::shown(w.degrees)), &*w.world.shapes.at(r.name)});
    }
  }
  return io::rotations_svg(io::picture_svg(p), angles);
}

formula::Pose pose_of(const Session& session) {
  formula::Pose pose{asked_position(session), asked_angle(session), std::nullopt};
  if (rotations(session.scene().free)) pose.about = about(session);
  return pose;
}

/// The shapes rotated by the pose's angle, their vertices rounded to the grid.
formula::World shown_world(const formula::Solver& solver, const formula::RotationSolver& rotated,
                           const formula::Pose& pose) {
  plane::Rounding drawn;
  return formula::rotated_world(solver.world(), rotated.about(), pose.degrees, drawn);
}

}  // namespace

bool asks_for_angle(const Session& session) {
  if (session.options().angle || rotations(session.scene().free)) return true;
  if (session.scene().motion.given()) return false;
  return formula::has_rotations(session.where());
}

bool asks_for_poses(const Session& session) { return session.scene().free.kind == Kind::kPose && !session.in_space(); }

Outcome measure_at_angle(const Session& session) {
  require_plane(session);
  const formula::Pose pose = pose_of(session);
  const formula::Solver solver(session.world());
  session.reporter().stage("measuring");
  const formula::RotationSolver rotated(solver, pose);
  const std::vector<formula::DistanceAt> distances = rotated.measure(session.where());
  say_rounding(session, rotated.rounding());
  const double degrees = pose.degrees.to_double();
  const auto json = [&] {
    return io::measure_json(distances, distance::coordinates(pose.at), session.unit(), degrees);
  };
  const auto svg = [&] { return measure_picture(session, shown_world(solver, rotated, pose), pose.at, distances); };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}});
  return {session.options().json
              ? json()
              : io::measure_text(distances, io::shown_point(distance::coordinates(pose.at)),
                                 distance::coordinates(pose.at), session.unit(), session.options().all),
          kDone};
}

Outcome check_at_angle(const Session& session) {
  require_plane(session);
  const formula::Pose pose = pose_of(session);
  const formula::Formula formula = session.where();
  const formula::Solver solver(session.world());
  session.reporter().stage("checking");
  const formula::RotationSolver rotated(solver, pose);
  const formula::Check check = rotated.check(formula);
  say_rounding(session, rotated.rounding());
  const auto json = [&] {
    return io::check_json(check, distance::coordinates(pose.at), session.unit(), pose.degrees.to_double(), {},
                          session.options().explain);
  };
  const auto svg = [&] {
    return check_picture(session, shown_world(solver, rotated, pose), formula, pose.at, check, nullptr);
  };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}});
  return {session.options().json
              ? json()
              : io::check_text(check, io::shown_point(distance::coordinates(pose.at)), distance::coordinates(pose.at),
                               session.unit(), {}, session.options().explain),
          check.holds ? kDone : kEmpty};
}

formula::Formula question_over_angles(const Session& session) {
  require_plane(session);
  const io::Scene& scene = session.scene();
  if (!session.options().apply.empty())
    throw Error(ErrorCode::kUsage, "--apply is for maps of the plane, not for those over angles");
  const auto goal = session.goal();
  if (goal && (scene.free.kind == Kind::kPose || goal->objective.kind != formula::Objective::Kind::kDistance))
    throw Error(ErrorCode::kUnsupported, "over angles only a distance can be an objective, over poses none",
                scene.file);
  if (scene.where.empty() && !goal)
    throw Error(ErrorCode::kBadValue, "the scene has no \"where\": nothing says what must hold", scene.file);
  return session.where();
}

namespace {

struct AngleMap {
  formula::SolvedAngles set;
  std::optional<distance::OptimalValue> best;
};

/// The angles at which the formula holds, or the best of them.
AngleMap solve(const Session& session, const formula::RotationMaps& maps, const formula::Formula& formula) {
  AngleMap map{formula::solve_angles(maps, formula), std::nullopt};
  if (const auto goal = session.goal()) {
    const bool negated = goal->objective.negated;
    const distance::Sense sense = negated ? opposite(goal->sense) : goal->sense;
    formula::BestAngles best = formula::best_angles(maps, goal->objective.distance, map.set, sense);
    if (negated) best.negate();
    map.best = best;
    map.set = std::move(best.at);
  }
  if (map.set.outer)
    session.reporter().note(
        "rotations about two points: angles that certainly belong, and in \"outer\" the possible ones");
  return map;
}

}  // namespace

Outcome map_of_angles(const Session& session) {
  check_outputs(session.options(), {".json", ".svg"});
  const formula::Formula formula = question_over_angles(session);
  const formula::Solver solver(session.world());
  session.reporter().stage("solving");
  const exact::RealPoint at = asked_position(session);
  const formula::RotationSolver rotated(solver, {at, {}, about(session)});
  AngleMap map = solve(session, rotated.maps(formula), formula);
  const distance::OptimalValue* extreme = map.best ? &*map.best : nullptr;
  const auto json = [&] {
    std::string text = io::rotations_json(map.set.angles, extreme);
    return map.set.outer ? io::bounded_json(std::move(text), io::rotations_json(*map.set.outer)) : text;
  };
  const auto angles = io::degree_intervals(map.set.angles);
  const auto svg = [&] { return picture(session, solver.world(), formula, at, angles); };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}});
  std::string text = rotations_text(session, angles, map.set.outer ? &*map.set.outer : nullptr);
  if (map.best) text += io::optimum_text(*map.best, "");
  const bool possible = map.set.outer && !io::degree_intervals(*map.set.outer).empty();
  return {session.options().json ? json() : text, !angles.empty() ? kDone : possible ? kLimit : kEmpty};
}

}  // namespace findspace::app
