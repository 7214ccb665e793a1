// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded_plane.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "findspace/text.h"
#include "formula/explain/explain.h"
#include "formula/planar/rotation_bounds.h"
#include "formula/planar/solve_rotation.h"
#include "io/draw/draw_region.h"
#include "io/question/planar_map.h"
#include "io/write/write_explanation.h"
#include "io/write/write_position.h"
#include "io/write/write_rotations.h"
#include "io/write/write_summary.h"
#include "io/write/write_witness.h"
#include "plane/complex/extent.h"
#include "plane/query/in_order.h"
#include "serve/features.h"

namespace findspace::app {
namespace {

using exact::Real;
using exact::RealPoint;
using Kind = io::Free::Kind;

/// Where unbounded sets are cut off in drawings, in sizes of what is bounded in the scene.
constexpr double kAround = 3;

/// The scene's coordinates; y runs downwards.
io::Frame drawing_frame(const plane::Bounds& world, bool y_down) {
  io::Frame frame;
  frame.world = world;
  frame.left = world.low[0];
  frame.y_down = y_down;
  frame.top = y_down ? world.low[1] : -world.high[1];
  return frame;
}

void include(std::optional<plane::PieceBox>& all, const std::optional<plane::PieceBox>& more) {
  if (more) all = all ? joined(*all, *more) : *more;
}

std::string places_json(const std::vector<plane::Place>& places) {
  return json_list(places,
                   [](const plane::Place& p) { return fmt::format("[{}, {}]", json_number(p[0]), json_number(p[1])); });
}

RealPoint point_of(const Spot& spot) { return {spot.at[0], spot.at[1]}; }

}  // namespace

LoadedPlane::LoadedPlane(io::Scene given) : Loaded(std::move(given)) {
  read_formula();
  with_session(
      [&](const Session& session) { upright_.solver = std::make_shared<const formula::Solver>(session.world()); });
}

void LoadedPlane::forget_answers() {
  if (scene().named_only) {  // of a board only the shapes that the formula names are there
    with_session(
        [&](const Session& session) { upright_.solver = std::make_shared<const formula::Solver>(session.world()); });
    rotated_.reset();
  }
  upright_.answers.reset();
  if (rotated_) rotated_->answers.reset();
}

RealPoint LoadedPlane::about() const {
  const io::GridPosition& p = scene().free.about;
  return {Real(p[0]), Real(p[1])};
}

const LoadedPlane::Rotated& LoadedPlane::rotated(const std::optional<Real>& degrees) const {
  if (!degrees || degrees->sign() == 0) return upright_;
  if (scene().motion.given()) refuse("an angle in a scene with \"motion\"");
  if (!rotated_ || !(rotated_->degrees == *degrees)) {
    Rotated made{*degrees, nullptr, {}, {}};
    made.solver = std::make_shared<const formula::Solver>(
        formula::rotated_world(solver().world(), about(), *degrees, made.rounding));
    rotated_ = std::move(made);
  }
  return *rotated_;
}

std::shared_ptr<const RegionAnswers> LoadedPlane::solved(const formula::Solver& solver,
                                                         const formula::Formula& formula) const {
  const bool line = scene().free.kind == Kind::kLine;
  const auto kept = [&](plane::Region region) { return line ? io::on_line(region, scene().free) : std::move(region); };
  const Real& step = solver.world().step;
  formula::SolvedRegion found = formula::solve_region(solver, formula);
  if (found.outer) found.outer = kept(*std::move(found.outer));
  return std::make_shared<const RegionAnswers>(kept(std::move(found.region)), std::move(found.outer), step);
}

const RegionAnswers& LoadedPlane::answers(const Rotated& rotated) const {
  require_moving();
  if (!rotated.answers) rotated.answers = solved(*rotated.solver, formula());
  return *rotated.answers;
}

std::string LoadedPlane::drawing_json(const plane::Region& region) const {
  const Real& step = solver().world().step;
  std::optional<plane::PieceBox> box = plane::extent(region);
  for (const auto& [name, shape] : solver().world().shapes) include(box, plane::extent(shape));
  const double size = step.to_double();
  plane::Bounds world{{-1, -1}, {1, 1}};
  if (box) world = {{box->x0 * size, box->y0 * size}, {box->x1 * size, box->y1 * size}};
  const double more = kAround * std::max(world.high[0] - world.low[0], world.high[1] - world.low[1]);
  for (int k : {0, 1}) {
    world.low[k] -= more;
    world.high[k] += more;
  }
  const plane::CurveNet net(region, step);
  const io::RegionDrawing d = io::region_drawing(net, drawing_frame(world, scene().y_down));
  return fmt::format(R"({{"faces": {}, "closed": {}, "open": {}, "free": {}, "points": {}, "full": {}, "hollow": {}}})",
                     json_string(d.faces), json_string(d.closed), json_string(d.open), json_string(d.free),
                     places_json(d.points), places_json(d.full), places_json(d.hollow));
}

std::string LoadedPlane::drawing_of(const std::string& shape) const {
  const auto found = solver().world().shapes.find(shape);
  return found == solver().world().shapes.end() ? "" : drawing_json(found->second);
}

std::string LoadedPlane::brief_json(const RegionAnswers& answers) const {
  const auto sample = answers.sample();
  const std::string at =
      sample ? io::json_point(distance::coordinates(distance::times(solver().world().step, *sample))) : "null";
  std::string out =
      fmt::format(R"({{"empty": {}, "sample": {}, "drawing": {})", !sample, at, drawing_json(answers.region()));
  if (answers.outer()) out += ", \"outer_drawing\": " + drawing_json(*answers.outer());
  return out + "}";
}

std::string LoadedPlane::map_json(const RegionQuery& query) const {
  require_moving();
  const Rotated& world = rotated(query.angle);
  const formula::Formula other = query.where ? parsed(*query.where) : formula::Formula{};
  const formula::Formula& wanted = query.where ? other : formula();
  const bool plain = scene().minimize.empty() && scene().maximize.empty() && query.apply.empty();
  if (query.brief && plain) return brief_json(query.where ? *solved(*world.solver, wanted) : answers(world));
  return with_session([&](const Session& session) {
    std::optional<formula::SolvedRegion> known;
    if (!query.where) {
      const RegionAnswers& all = answers(world);
      known = {all.in_order()};
      if (all.outer()) known->outer = plane::in_order(*all.outer());
    }
    io::PlanarMap map = io::planar_map(session, *world.solver, wanted, {query.apply, "--"}, known ? &*known : nullptr);
    if (query.brief) {
      return brief_json(RegionAnswers(std::move(map.region), std::move(map.outer), solver().world().step));
    }
    std::string out = io::planar_map_json(session, map, false);
    if (!query.drawing) return out;
    out = with_member(std::move(out), "drawing", drawing_json(map.region));
    return map.outer ? with_member(std::move(out), "outer_drawing", drawing_json(*map.outer)) : out;
  });
}

formula::TriedNearest LoadedPlane::nearest(const Rotated& rotated, const RealPoint& at) const {
  const Real& step = solver().world().step;
  const RegionAnswers& known = answers(rotated);
  const auto near = known.nearest({at.x / step, at.y / step});
  if (!near && known.outer()) return exact::Refusal("the region is known between bounds, and no position is certain");
  if (!near) return std::optional<formula::NearestFeasible>();
  return std::optional(formula::NearestFeasible{distance::coordinates(distance::times(step, near->at)),
                                                near->distance * step, near->attained});
}

formula::Check LoadedPlane::check(const Spot& spot, const RealPoint& at) const {
  if (spot.time) {
    formula::World world = solver().world();
    if (!world.motion.given()) throw Error(ErrorCode::kBadValue, "the scene has no \"motion\"", scene().file);
    if (*spot.time < world.motion.start || world.motion.end < *spot.time)
      throw Error(ErrorCode::kBadValue, "that instant lies outside the motion", scene().file);
    world.instant = *spot.time;
    return formula::Solver(std::move(world)).check(formula(), at);
  }
  if (!formula::has_rotations(formula())) return rotated(spot.angle).solver->check(formula(), at);
  formula::Pose pose{at, spot.angle.value_or(Real()), std::nullopt};
  const Real& step = solver().world().step;
  if (scene().free.kind == Kind::kAngle || scene().free.kind == Kind::kPose)
    pose.about = distance::times(step, about());
  return formula::RotationSolver(solver(), pose).check(formula());
}

std::string LoadedPlane::check_json(const Spot& spot, const CheckQuery& query) const {
  require_moving();
  RealPoint at = point_of(spot);
  const Rotated& world = rotated(spot.angle);
  if (query.snap.sign() > 0) {
    const Real& step = solver().world().step;
    const auto near = answers(world).snapped({at.x / step, at.y / step}, query.snap / step);
    if (near) at = distance::times(step, *near);
  }
  const formula::Check found = check(spot, at);
  formula::AskedNearest near;
  if (query.nearest && !found.holds && !spot.time) near = nearest(world, at);
  const bool turns = spot.angle || scene().free.kind == Kind::kAngle || scene().free.kind == Kind::kPose;
  return io::check_json(found, distance::coordinates(at), unit(),
                        turns ? std::optional(spot.angle.value_or(Real()).to_double()) : std::nullopt, near);
}

formula::TriedNearest LoadedPlane::nearest(const Spot& spot) const {
  return nearest(rotated(spot.angle), point_of(spot));
}

std::string LoadedPlane::measure_json(const Spot& spot) const {
  require_moving();
  const RealPoint at = point_of(spot);
  return io::measure_json(rotated(spot.angle).solver->measure(at, formula()), distance::coordinates(at), unit());
}

std::string LoadedPlane::explain_json(const std::optional<Spot>& spot) const {
  require_moving();
  const formula::Solver& world = *rotated(spot ? spot->angle : std::nullopt).solver;
  const formula::Explanation explanation = formula::explain(world, formula());
  std::optional<formula::PositionExplanation> here;
  RealPoint at;
  if (spot && !spot->at.empty()) {
    at = point_of(*spot);
    here = formula::explain_at(world, formula(), at);
  }
  return io::explanation_json(
      {formula(), explanation, here ? &*here : nullptr, distance::coordinates(at), solver().world().step, unit()});
}

std::string LoadedPlane::angles_json(const Spot& spot) const {
  require_moving();
  if (scene().motion.given()) refuse("a map of angles in a scene with \"motion\"");
  const Real& step = solver().world().step;
  const formula::RotationSolver rotation(solver(), {point_of(spot), {}, distance::times(step, about())});
  const formula::RotationMaps maps = rotation.maps(formula());
  const formula::SolvedAngles found = formula::solve_angles(maps, formula());
  std::string text = io::rotations_json(found.angles);
  return found.outer ? io::bounded_json(std::move(text), io::rotations_json(*found.outer)) : text;
}

std::string LoadedPlane::instants_json(const Spot& spot) const {
  require_moving();
  if (!scene().motion.given()) throw Error(ErrorCode::kBadValue, "the scene has no \"motion\"", scene().file);
  return io::planar_instants(solver(), formula(), point_of(spot)).json();
}

std::string LoadedPlane::between_json(const Spot& spot, const std::array<RealPoint, 2>& places) const {
  const Rotated& world = rotated(spot.angle);
  return features_between(world.solver->world(), spot.at.empty() ? RealPoint{} : point_of(spot), places, unit());
}

}  // namespace findspace::app
