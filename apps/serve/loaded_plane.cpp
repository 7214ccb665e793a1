// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded_plane.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "formula/explain/explain.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/rotation_bounds.h"
#include "formula/planar/solve_rotation.h"
#include "io/draw/draw_region.h"
#include "io/write/json_text.h"
#include "io/write/write_explanation.h"
#include "io/write/write_position.h"
#include "io/write/write_rotations.h"
#include "io/write/write_witness.h"
#include "planar_map.h"
#include "plane/query/in_order.h"
#include "plane/query/locate.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"
#include "report.h"
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

void include(std::optional<plane::Bounds>& all, const std::optional<plane::Bounds>& more) {
  if (!more) return;
  if (!all) all = more;
  for (int k : {0, 1}) {
    all->low[k] = std::min(all->low[k], more->low[k]);
    all->high[k] = std::max(all->high[k], more->high[k]);
  }
}

std::string places_json(const std::vector<plane::Place>& places) {
  return io::list(places, [](const plane::Place& p) {
    return fmt::format("[{}, {}]", io::json_number(p[0]), io::json_number(p[1]));
  });
}

RealPoint point_of(const Spot& spot) { return {spot.at[0], spot.at[1]}; }

bool has_rotations(const formula::Formula& formula) {
  return std::any_of(formula.atoms().begin(), formula.atoms().end(),
                     [](const formula::Atom& a) { return a.distance.mode == formula::Mode::kRotation; });
}

bool is_in(plane::Mark m) { return m > 0; }

/// The vertices alone, without those that only join two pieces of one circle.
plane::Region corners_of(plane::Region region, const Real& step) {
  const plane::CurveNet net(region, step);
  for (plane::Index v = 0; v < region.vertices.size(); ++v)
    if (net.number(v) == plane::kNone) region.vertices[v].mark = 0;
  for (plane::Edge& e : region.edges) e.mark = 0;
  for (plane::Face& f : region.faces) f.mark = 0;
  return region;
}

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

LoadedPlane::Answers LoadedPlane::solved(const formula::Solver& solver, const formula::Formula& formula) const {
  Answers out;
  if (solver.rotations_in(formula)) {
    formula::RegionBounds bounds = solver.feasible_bounds(formula);
    out.region = plane::in_order(std::move(bounds.inner));
    out.outer = plane::in_order(std::move(bounds.outer));
  } else {
    out.region = plane::in_order(formula::feasible_near(solver, formula));
  }
  if (scene().free.kind == Kind::kLine) {
    out.region = on_line(out.region, scene().free);
    if (out.outer) out.outer = on_line(*out.outer, scene().free);
  }
  out.closure = plane::closure(out.region);
  out.boundary = plane::boundary(out.closure);
  out.corners = corners_of(out.closure, solver.world().step);
  return out;
}

const LoadedPlane::Answers& LoadedPlane::answers(const Rotated& rotated) const {
  require_moving();
  if (!rotated.answers) rotated.answers = solved(*rotated.solver, formula());
  return *rotated.answers;
}

std::string LoadedPlane::drawing_json(const plane::Region& region) const {
  const Real& step = solver().world().step;
  std::optional<plane::Bounds> box = plane::summarize(region, step).bbox;
  for (const auto& [name, shape] : solver().world().shapes) include(box, plane::summarize(shape, step).bbox);
  plane::Bounds world = box.value_or(plane::Bounds{{-1, -1}, {1, 1}});
  const double more = kAround * std::max(world.high[0] - world.low[0], world.high[1] - world.low[1]);
  for (int k : {0, 1}) {
    world.low[k] -= more;
    world.high[k] += more;
  }
  const plane::CurveNet net(region, step);
  const io::RegionDrawing d = io::region_drawing(net, drawing_frame(world, scene().y_down));
  return fmt::format(R"({{"faces": {}, "closed": {}, "open": {}, "free": {}, "points": {}, "full": {}, "hollow": {}}})",
                     io::json_string(d.faces), io::json_string(d.closed), io::json_string(d.open),
                     io::json_string(d.free), places_json(d.points), places_json(d.full), places_json(d.hollow));
}

std::string LoadedPlane::drawing_of(const std::string& shape) const {
  const auto found = solver().world().shapes.find(shape);
  return found == solver().world().shapes.end() ? "" : drawing_json(found->second);
}

std::string LoadedPlane::map_json(const RegionWish& wish) const {
  require_moving();
  const Rotated& world = rotated(wish.angle);
  const formula::Formula other = wish.where ? parsed(*wish.where) : formula::Formula{};
  const formula::Formula& wanted = wish.where ? other : formula();
  Options options;
  options.apply = wish.apply;
  return with_session(options, [&](const Session& session) {
    std::optional<formula::RegionBounds> known;
    if (!wish.where)
      known = formula::RegionBounds{answers(world).region, answers(world).outer.value_or(plane::Region{})};
    const PlanarMap map = planar_map(session, *world.solver, wanted, known ? &*known : nullptr);
    std::string out = planar_map_json(session, map);
    if (!wish.drawing) return out;
    out.resize(out.rfind('}'));
    out += ", \"drawing\": " + drawing_json(map.region);
    if (map.outer) out += ", \"outer_drawing\": " + drawing_json(*map.outer);
    return out + "}";
  });
}

std::optional<formula::NearestFeasible> LoadedPlane::nearest(const Rotated& rotated, const RealPoint& at) const {
  const Answers& all = answers(rotated);
  const Real& step = solver().world().step;
  const RealPoint p{at.x / step, at.y / step};
  const auto belongs = [&](const RealPoint& q) { return mark_of(all.region, plane::locate(all.region, q)) > 0; };
  if (mark_of(all.closure, plane::locate(all.closure, p)) > 0)
    return formula::NearestFeasible{distance::coordinates(at), Real(), belongs(p)};
  const auto near = plane::nearest(all.closure, is_in, p);
  if (!near) return std::nullopt;
  return formula::NearestFeasible{distance::coordinates(distance::times(step, near->at)), near->distance * step,
                                  belongs(near->at)};
}

std::optional<RealPoint> LoadedPlane::snapped(const Rotated& rotated, const RealPoint& at, const Real& within) const {
  const Answers& all = answers(rotated);
  const Real& step = solver().world().step;
  const RealPoint p{at.x / step, at.y / step};
  for (const plane::Region* set : {&all.corners, &all.boundary}) {
    const auto near = plane::nearest(*set, is_in, p);
    if (near && near->distance * step <= within && mark_of(all.region, plane::locate(all.region, near->at)) > 0)
      return distance::times(step, near->at);
  }
  return std::nullopt;
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
  if (!has_rotations(formula())) return rotated(spot.angle).solver->check(formula(), at);
  formula::Pose pose{at, spot.angle.value_or(Real()), std::nullopt};
  const Real& step = solver().world().step;
  if (scene().free.kind == Kind::kAngle || scene().free.kind == Kind::kPose)
    pose.about = distance::times(step, about());
  return formula::RotationSolver(solver(), pose).check(formula());
}

std::string LoadedPlane::check_json(const Spot& spot, const CheckWish& wish) const {
  require_moving();
  RealPoint at = point_of(spot);
  const Rotated& world = rotated(spot.angle);
  if (wish.snap.sign() > 0) at = snapped(world, at, wish.snap).value_or(at);
  const formula::Check found = check(spot, at);
  const auto near = wish.nearest && !found.holds && !spot.time ? nearest(world, at) : std::nullopt;
  const bool turns = spot.angle || scene().free.kind == Kind::kAngle || scene().free.kind == Kind::kPose;
  return io::check_json(found, distance::coordinates(at), unit(),
                        turns ? std::optional(spot.angle.value_or(Real()).to_double()) : std::nullopt,
                        near ? &*near : nullptr);
}

std::string LoadedPlane::nearest_json(const Spot& spot) const {
  const auto near = nearest(rotated(spot.angle), point_of(spot));
  if (!near) return R"({"nearest_feasible": null})";
  return fmt::format(R"({{"nearest_feasible": {{"at": {}, "distance": {}, "attained": {}}}}})",
                     io::json_point(near->at), io::json_number(near->distance.to_double()), io::truth(near->attained));
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
  return io::explanation_json({formula(), explanation, here ? &*here : nullptr, at, solver().world().step, unit()});
}

std::string LoadedPlane::angles_json(const Spot& spot) const {
  require_moving();
  if (scene().motion.given()) refuse("a map of angles in a scene with \"motion\"");
  const Real& step = solver().world().step;
  const formula::RotationSolver rotation(solver(), {point_of(spot), {}, distance::times(step, about())});
  const formula::RotationMaps maps = rotation.maps(formula());
  if (!maps.rotations_twice(formula())) return io::rotations_json(maps.feasible(formula()));
  const formula::RotationBounds bounds = formula::rotation_bounds(maps, formula());
  return bounded_json(io::rotations_json(bounds.inner), io::rotations_json(bounds.outer));
}

std::string LoadedPlane::instants_json(const Spot& spot) const {
  require_moving();
  if (!scene().motion.given()) throw Error(ErrorCode::kBadValue, "the scene has no \"motion\"", scene().file);
  return planar_instants(solver(), formula(), point_of(spot)).json();
}

std::string LoadedPlane::between_json(const Spot& spot, const std::array<RealPoint, 2>& places) const {
  const Rotated& world = rotated(spot.angle);
  return features_between(world.solver->world(), spot.at.empty() ? RealPoint{} : point_of(spot), places, unit());
}

}  // namespace findspace::app
