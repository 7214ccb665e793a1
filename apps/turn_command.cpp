// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "turn_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/draw/draw_layout.h"
#include "io/write/draw_turns.h"
#include "io/write/write_json.h"
#include "io/write/write_turns.h"
#include "plane/query/measure_cells_twofold.h"
#include "position_picture.h"
#include "report.h"

namespace findspace::app {
namespace {

using Kind = io::Free::Kind;

bool turns(const io::Free& free) { return free.kind == Kind::kAngle || free.kind == Kind::kPose; }

exact::RealPoint about(const Session& session) {
  const io::GridPosition& p = session.scene().free.about;
  return {exact::Real(p[0]) * session.step(), exact::Real(p[1]) * session.step()};
}

void require_plane(const Session& session) {
  const io::Scene& scene = session.scene();
  if (scene.dimension != 2)
    throw Error(ErrorCode::kUnsupported, "turning shapes in space is not computed by this version", scene.file);
  if (scene.motion.given())
    throw Error(ErrorCode::kUnsupported, "an angle in a scene with \"motion\" is not computed", scene.file);
  if (scene.moving.empty())
    throw Error(ErrorCode::kBadValue, "the scene does not say which shape is \"moving\"", scene.file);
}

void say_rounding(const Session& session, const plane::Rounding& rounding) {
  if (rounding.points == 0) return;
  session.talk().note(fmt::format("{} vertices of the turned shape were put on the grid, moved by at most {:.2g} {}",
                                  rounding.points, rounding.largest * session.scene().grid.step_size(),
                                  session.unit()));
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
std::string turns_text(const Session& session, const std::vector<io::DegreeInterval>& angles,
                       const plane::TurnMap* outer) {
  std::string out = fmt::format("Angles of {}, in degrees\n", fmt::join(session.scene().moving, ", "));
  const std::string possible = outer != nullptr ? angles_text(io::degree_intervals(*outer)) : "";
  out += !angles.empty() ? angles_text(angles) : possible.empty() ? "  none: proven empty\n" : "  none certain\n";
  if (!possible.empty()) out += "possible\n" + possible;
  return out;
}

/// The moving shapes as they stand at the ends of the intervals, a few of them.
struct Station {
  double degrees;
  situation::World world;
};

std::vector<Station> stations(const situation::World& world, const exact::RealPoint& about,
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
    out.push_back({d, situation::turned_world(world, centre, exact::Real::from_double(d), rounding)});
  return out;
}

std::string picture(const Session& session, const situation::World& world, const situation::Formula& formula,
                    const exact::RealPoint& at, const std::vector<io::DegreeInterval>& angles) {
  io::Picture p;
  p.title = fmt::format("Angles of {}{}", fmt::join(session.scene().moving, ", "), angles.empty() ? ": none" : "");
  p.subtitle = session.scene().where.text;
  p.of_positions = false;
  p.position = {plane::Twofold(at.x).value(), plane::Twofold(at.y).value()};
  session.add_scenery(p, world, &formula);
  const auto shown = stations(world, about(session), angles);
  for (const Station& w : shown) {
    for (const io::NamedRegion& r : p.moving) {
      p.turned.push_back({fmt::format("{}°", io::shown(w.degrees)), &w.world.shapes.at(r.name)});
    }
  }
  return io::turns_svg(io::picture_svg(p), angles);
}

situation::Pose pose_of(const Session& session) {
  situation::Pose pose{session.position(), session.angle(), std::nullopt};
  if (turns(session.scene().free)) pose.about = about(session);
  return pose;
}

/// The shapes turned by the pose's angle, their vertices rounded to the grid.
situation::World shown_world(const situation::Solver& solver, const situation::TurnSolver& turned,
                             const situation::Pose& pose) {
  plane::Rounding drawn;
  return situation::turned_world(solver.world(), turned.about(), pose.degrees, drawn);
}

}  // namespace

bool asks_for_angle(const Session& session) {
  if (session.options().angle || turns(session.scene().free)) return true;
  if (session.scene().motion.given()) return false;
  const situation::Formula formula = session.where();
  return std::any_of(formula.atoms().begin(), formula.atoms().end(),
                     [](const situation::Atom& a) { return a.distance.mode == situation::Mode::kTurning; });
}

Outcome measure_at_angle(const Session& session) {
  require_plane(session);
  const situation::Pose pose = pose_of(session);
  const situation::Solver solver(session.world());
  session.talk().stage("measuring");
  const situation::TurnSolver turned(solver, pose);
  const std::vector<situation::DistanceAt> distances = turned.measure(session.where());
  say_rounding(session, turned.rounding());
  const double degrees = pose.degrees.to_double();
  const auto json = [&] { return io::measure_json(distances, pose.at, session.step(), session.unit(), degrees); };
  const auto svg = [&] { return measure_picture(session, shown_world(solver, turned, pose), pose.at, distances); };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}});
  return {session.options().json ? json() : measure_text(distances, pose.at, session.step(), session.unit()), kDone};
}

Outcome check_at_angle(const Session& session) {
  require_plane(session);
  const situation::Pose pose = pose_of(session);
  const situation::Formula formula = session.where();
  const situation::Solver solver(session.world());
  session.talk().stage("checking");
  const situation::TurnSolver turned(solver, pose);
  const situation::Solver::Check check = turned.check(formula);
  say_rounding(session, turned.rounding());
  const auto json = [&] {
    return io::check_json(check, pose.at, session.step(), session.unit(), pose.degrees.to_double());
  };
  const auto svg = [&] {
    return check_picture(session, shown_world(solver, turned, pose), formula, pose.at, check, nullptr);
  };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}});
  return {session.options().json ? json() : check_text(check, pose.at, session.step(), session.unit(), nullptr),
          check.holds ? kDone : kEmpty};
}

situation::Formula question_over_angles(const Session& session) {
  require_plane(session);
  const io::Scene& scene = session.scene();
  if (!session.options().apply.empty())
    throw Error(ErrorCode::kUsage, "--apply is for maps of the plane, not for those over angles");
  const auto goal = session.goal();
  if (goal && (scene.free.kind == Kind::kPose || goal->objective.kind != situation::Objective::Kind::kDistance))
    throw Error(ErrorCode::kUnsupported, "over angles only a distance can be an objective, over poses none",
                scene.file);
  if (scene.where.empty() && !goal)
    throw Error(ErrorCode::kBadValue, "the scene has no \"where\": nothing says what must hold", scene.file);
  return session.where();
}

namespace {

/// The best angles of the set take its place.
std::optional<io::ExtremeValue> optimum(const Session& session, const situation::TurnSolver& solver,
                                        plane::TurnMap& set) {
  const auto goal = session.goal();
  if (!goal) return std::nullopt;
  const bool maximum = goal->sense == distance::Sense::kMaximum, negated = goal->objective.negated;
  const situation::Distance& d = goal->objective.distance;
  plane::TurnLeast best = maximum != negated ? solver.greatest(d, set) : solver.least(d, set);
  set = std::move(best.at);
  if (!best.exists) return io::ExtremeValue{maximum, std::nullopt, false, false, true};
  const double value = best.value.to_double();
  return io::ExtremeValue{maximum, negated ? -value : value, false, best.attained, best.proven};
}

struct AngleMap {
  plane::TurnMap set;
  std::optional<plane::TurnMap> outer;  // where the set is certain, and only this possible
  std::optional<io::ExtremeValue> best;
};

/// The best angles of a set that is known between bounds, or of a distance that is.
AngleMap solve_between_bounds(const Session& session, const situation::TurnSolver& turned,
                              const situation::Formula& formula) {
  session.talk().note("turns about two points: angles that certainly belong, and in \"outer\" the possible ones");
  situation::TurnSolver::Bounds bounds = turned.feasible_bounds(formula);
  const auto goal = session.goal();
  if (!goal) return {std::move(bounds.inner), std::move(bounds.outer), std::nullopt};
  const bool maximum = goal->sense == distance::Sense::kMaximum, negated = goal->objective.negated;
  situation::TurnSolver::Best best = turned.best(
      goal->objective.distance, bounds, maximum != negated ? distance::Sense::kMaximum : distance::Sense::kMinimum);
  const double turn = negated ? -1 : 1;
  io::ExtremeValue extreme{maximum, std::nullopt, false, false, false};
  if (best.value) extreme.value = turn * *best.value;
  if (best.none)
    extreme.proven = true;
  else
    extreme.bound = turn * best.bound;
  return {plane::TurnMap::uniform(0), std::move(best.possible), extreme};
}

AngleMap solve(const Session& session, const situation::TurnSolver& turned, const situation::Formula& formula) {
  const auto goal = session.goal();
  if (turned.turns_twice(formula) || (goal && turned.turns_twice(goal->objective.distance)))
    return solve_between_bounds(session, turned, formula);
  AngleMap map{turned.feasible(formula), std::nullopt, std::nullopt};
  map.best = optimum(session, turned, map.set);
  return map;
}

}  // namespace

Outcome map_of_angles(const Session& session) {
  check_outputs(session.options(), {".json", ".svg"});
  const situation::Formula formula = question_over_angles(session);
  const situation::Solver solver(session.world());
  session.talk().stage("solving");
  const exact::RealPoint at = session.position();
  const situation::TurnSolver turned(solver, {at, {}, about(session)});
  AngleMap map = solve(session, turned, formula);
  const io::ExtremeValue* extreme = map.best ? &*map.best : nullptr;
  const auto json = [&] {
    std::string text = io::turns_json(map.set, extreme);
    return map.outer ? bounded_json(std::move(text), io::turns_json(*map.outer)) : text;
  };
  const auto angles = io::degree_intervals(map.set);
  const auto svg = [&] { return picture(session, solver.world(), formula, at, angles); };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}});
  std::string text = turns_text(session, angles, map.outer ? &*map.outer : nullptr);
  if (map.best && map.best->value)
    text += fmt::format("{} {}\n", map.best->maximum ? "maximum" : "minimum", io::shown(*map.best->value));
  const bool possible = map.outer && !io::degree_intervals(*map.outer).empty();
  return {session.options().json ? json() : text, !angles.empty() ? kDone : possible ? kLimit : kEmpty};
}

}  // namespace findspace::app
