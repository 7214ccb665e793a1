// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "formula/language/text.h"
#include "formula/planar/feasible_near.h"
#include "io/draw/draw_region.h"
#include "io/write/json_text.h"
#include "io/write/write_explanation.h"
#include "io/write/write_position.h"
#include "io/write/write_witness.h"
#include "plane/query/in_order.h"
#include "plane/query/locate.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"

namespace findspace::app {
namespace {

/// Where unbounded sets are cut off in drawings, in sizes of what is bounded in the scene.
constexpr double kAround = 3;

/// The scene's coordinates with y down.
io::Frame drawing_frame(const plane::Bounds& world) {
  io::Frame frame;
  frame.world = world;
  frame.left = world.low[0];
  frame.top = -world.high[1];
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

}  // namespace

template <class Use>
auto LoadedScene::with_session(const io::Scene& scene, const Use& use) const {
  const Options options;
  Reporter reporter(true);
  return use(Session(options, reporter, scene));
}

LoadedScene::LoadedScene(io::Scene scene) : scene_(std::move(scene)) {
  with_session(scene_, [&](const Session& session) {
    session.require_positions(false);
    formula_ = session.where();
    solver_ = std::make_shared<const formula::Solver>(session.world());
  });
}

formula::Formula LoadedScene::parsed(const std::string& where) const {
  if (where.empty()) return {};
  return with_session(scene_, [&](const Session& session) { return formula::parse_formula(where, session.context()); });
}

void LoadedScene::set_where(const std::string& where) {
  formula_ = parsed(where);
  scene_.where = {where, "formula", 1, 1};
  region_.reset();
}

void LoadedScene::set_moving(const std::vector<std::string>& moving) {
  io::Scene other = scene_;
  for (const std::string& name : moving) other.shape(name);
  other.moving = moving;
  *this = LoadedScene(std::move(other));
}

std::string LoadedScene::unit() const { return scene_.unit ? std::string(formula::name(*scene_.unit)) : ""; }

std::string LoadedScene::shape_json(const std::string& name, bool drawing) const {
  const bool moves = std::find(scene_.moving.begin(), scene_.moving.end(), name) != scene_.moving.end();
  const auto& atoms = formula_.atoms();
  const bool used = std::any_of(atoms.begin(), atoms.end(), [&](const formula::Atom& a) {
    const std::vector<std::string>& first = a.distance.first;
    const std::vector<std::string>& second = a.distance.second;
    return std::find(first.begin(), first.end(), name) != first.end() ||
           std::find(second.begin(), second.end(), name) != second.end();
  });
  std::string out = fmt::format(R"({{"name": {}, "moving": {}, "used": {})", io::json_string(name), io::truth(moves),
                                io::truth(used));
  if (drawing) out += ", \"drawing\": " + drawing_json(solver_->world().shapes.at(name));
  return out + "}";
}

std::string LoadedScene::summary_json(bool drawing) const {
  std::vector<std::string> names;
  for (const plane::ShapePtr& s : scene_.shapes) names.push_back(s->name);
  return fmt::format(R"({{{}"step": {}, "where": {}, "moving": {}, "shapes": {}}})", io::unit_key(unit()),
                     io::json_number(solver_->world().step.to_double()), io::json_string(scene_.where.text),
                     io::list(scene_.moving, io::json_string),
                     io::list(names, [&](const std::string& name) { return shape_json(name, drawing); }));
}

std::string LoadedScene::drawing_json(const plane::Region& region) const {
  const exact::Real& step = solver_->world().step;
  std::optional<plane::Bounds> box = plane::summarize(region, step).bbox;
  for (const auto& [name, shape] : solver_->world().shapes) include(box, plane::summarize(shape, step).bbox);
  plane::Bounds world = box.value_or(plane::Bounds{{-1, -1}, {1, 1}});
  const double more = kAround * std::max(world.high[0] - world.low[0], world.high[1] - world.low[1]);
  for (int k : {0, 1}) {
    world.low[k] -= more;
    world.high[k] += more;
  }
  const plane::CurveNet net(region, step);
  const io::RegionDrawing d = io::region_drawing(net, drawing_frame(world));
  return fmt::format(R"({{"faces": {}, "closed": {}, "open": {}, "free": {}, "points": {}, "full": {}, "hollow": {}}})",
                     io::json_string(d.faces), io::json_string(d.closed), io::json_string(d.open),
                     io::json_string(d.free), places_json(d.points), places_json(d.full), places_json(d.hollow));
}

std::string LoadedScene::map_json(bool drawing, const std::optional<std::string>& where) const {
  const plane::Region shown = where ? plane::in_order(formula::feasible_near(*solver_, parsed(*where))) : region();
  const plane::Summary summary = plane::summarize(shown, solver_->world().step);
  std::string out = io::region_json(shown, summary, solver_->world().step, unit());
  if (!drawing) return out;
  out.resize(out.rfind('}'));
  return out + ", \"drawing\": " + drawing_json(shown) + "}";
}

const plane::Region& LoadedScene::region() const {
  if (!region_) {
    region_ = plane::in_order(formula::feasible_near(*solver_, formula_));
    closure_ = plane::closure(*region_);
  }
  return *region_;
}

std::optional<formula::NearestFeasible> LoadedScene::nearest(const exact::RealPoint& at) const {
  const plane::Region& all = region();
  const exact::Real& step = solver_->world().step;
  const exact::RealPoint p{at.x / step, at.y / step};
  if (mark_of(*closure_, plane::locate(*closure_, p)) > 0)
    return formula::NearestFeasible{distance::coordinates(at), exact::Real(), mark_of(all, plane::locate(all, p)) > 0};
  const auto near = plane::nearest(
      *closure_, [](plane::Mark m) { return m > 0; }, p);
  if (!near) return std::nullopt;
  return formula::NearestFeasible{distance::coordinates(distance::times(step, near->at)), near->distance * step,
                                  mark_of(all, plane::locate(all, near->at)) > 0};
}

std::string LoadedScene::check_json(const exact::RealPoint& at, bool wanted, const exact::Real& snap) const {
  std::optional<formula::NearestFeasible> near;
  if (wanted || snap.sign() > 0) near = nearest(at);
  if (near && near->attained && near->distance.sign() > 0 && near->distance <= snap)
    return check_json({near->at[0], near->at[1]}, false, exact::Real());
  const formula::Check check = solver_->check(formula_, at);
  return io::check_json(check, distance::coordinates(at), unit(), std::nullopt,
                        near && wanted && !check.holds ? &*near : nullptr);
}

std::string LoadedScene::nearest_json(const exact::RealPoint& at) const {
  const auto near = nearest(at);
  if (!near) return R"({"nearest_feasible": null})";
  return fmt::format(R"({{"nearest_feasible": {{"at": {}, "distance": {}, "attained": {}}}}})",
                     io::json_point(near->at), io::json_number(near->distance.to_double()), io::truth(near->attained));
}

std::string LoadedScene::measure_json(const exact::RealPoint& at) const {
  return io::measure_json(solver_->measure(at, formula_), distance::coordinates(at), unit());
}

std::string LoadedScene::explain_json(const std::optional<exact::RealPoint>& at) const {
  const formula::Explanation explanation = formula::explain(*solver_, formula_);
  std::optional<formula::PositionExplanation> here;
  if (at) here = formula::explain_at(*solver_, formula_, *at);
  return io::explanation_json(
      {formula_, explanation, here ? &*here : nullptr, at.value_or(exact::RealPoint{}), solver_->world().step, unit()});
}

}  // namespace findspace::app
