// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// include/findspace/region.h and world.h: a scene made of the shapes' texts, and a solver over it.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "findspace/world.h"
#include "formula/language/parse.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/optimize.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/solve_rotation.h"
#include "io/scene/scene.h"
#include "io/write/write_json.h"
#include "io/write/write_witness.h"
#include "plane/build/build.h"
#include "plane/complex/overlay.h"
#include "plane/query/in_order.h"

namespace findspace {

struct Region::Data {
  plane::Region region;
  plane::Summary summary;
  exact::Real step;
  std::string unit;
};

struct SignMap::Data {
  plane::SignMap map;
  exact::Real step;
  std::string unit;
};

struct World::Data {
  io::Scene scene;
  formula::Context context;
  formula::Solver solver;

  formula::Formula formula(std::string_view text) const { return formula::parse_formula(text, context); }
  /// Throws where the text is a coordinate or no objective at all.
  formula::Objective distance(std::string_view text) const {
    const formula::Objective wanted = formula::parse_objective(text, context);
    if (wanted.kind != formula::Objective::Kind::kDistance)
      throw Error(ErrorCode::kBadValue, fmt::format("'{}' is no distance of shapes", text));
    return wanted;
  }
  /// At p, in the scene's unit, the shapes rotated as they are given.
  formula::Check check(const formula::Formula& f, const exact::RealPoint& p) const {
    const bool rotating = std::any_of(f.atoms().begin(), f.atoms().end(), [](const formula::Atom& a) {
      return a.distance.mode == formula::Mode::kRotation;
    });
    return rotating ? formula::RotationSolver(solver, {p, {}, {}}).check(f) : solver.check(f, p);
  }
  std::string unit() const { return scene.unit ? std::string(formula::name(*scene.unit)) : ""; }
  Region region(plane::Region r) const;
};

namespace {

exact::RealPoint real(const Point& p) {
  return {exact::Real::parse_decimal(p.x.text()), exact::Real::parse_decimal(p.y.text())};
}

exact::RealPoint steps(const Point& p, const exact::Real& step) {
  exact::RealPoint q = real(p);
  return {q.x / step, q.y / step};
}

Region make_region(plane::Region r, const exact::Real& step, const std::string& unit) {
  plane::Summary summary = plane::summarize(r, step);
  return Region(std::make_shared<const Region::Data>(Region::Data{std::move(r), std::move(summary), step, unit}));
}

io::Scene scene_of(const std::map<std::string, Shape>& shapes, const std::string& moving, const WorldOptions& o) {
  std::string text =
      fmt::format("{{\"findspace\": 1, \"grid\": {}, \"moving\": {},", o.grid.text(), io::json_string(moving));
  if (!o.unit.empty()) text += fmt::format(" \"unit\": {},", io::json_string(o.unit));
  text += " \"shapes\": {";
  const char* separator = "";
  for (const auto& [name, shape] : shapes) {
    text += fmt::format("{}\n{}: {}", separator, io::json_string(name), shape.text());
    separator = ",";
  }
  return io::read_scene_text(text + "}}", std::filesystem::current_path(), "world");
}

formula::World world_of(const io::Scene& scene) {
  formula::World world;
  for (const plane::ShapePtr& s : scene.shapes)
    world.shapes.emplace(s->name, plane::build(*s, scene.grid.step_size()).region);
  world.moving = scene.moving;
  world.step = scene.grid.step();
  return world;
}

formula::Context context_of(const io::Scene& scene) {
  formula::Context context;
  for (const plane::ShapePtr& s : scene.shapes) context.shapes.push_back(s->name);
  context.moving = scene.moving;
  context.unit = scene.unit;
  return context;
}

}  // namespace

bool Region::empty() const { return data_->summary.empty; }
bool Region::whole() const { return data_->summary.whole; }
bool Region::open() const { return data_->summary.open; }
bool Region::closed() const { return data_->summary.closed; }
bool Region::bounded() const { return data_->summary.bounded; }
std::optional<double> Region::area() const { return data_->summary.area; }
std::size_t Region::components() const { return data_->summary.components.size(); }
std::size_t Region::holes() const { return std::size_t(data_->summary.holes); }
bool Region::contains(const Point& p) const {
  return plane::mark_of(data_->region, plane::locate(data_->region, steps(p, data_->step))) > 0;
}
std::string Region::json() const { return io::region_json(data_->region, data_->summary, data_->step, data_->unit); }

int SignMap::sign(const Point& p) const {
  return plane::mark_of(data_->map, plane::locate(data_->map, steps(p, data_->step)));
}

Region SignMap::where(bool negative, bool zero, bool positive) const {
  auto wanted = [=](plane::Mark m) { return plane::Mark(m < 0 ? negative : m == 0 ? zero : positive); };
  return make_region(plane::remark(data_->map, wanted), data_->step, data_->unit);
}

Region World::Data::region(plane::Region r) const { return make_region(plane::in_order(r), scene.grid.step(), unit()); }

World::World(const std::map<std::string, Shape>& shapes, const std::string& moving, const WorldOptions& options) {
  io::Scene scene = scene_of(shapes, moving, options);
  if (scene.dimension != 2) throw Error(ErrorCode::kUnsupported, "a world of three dimensions");
  formula::Context context = context_of(scene);
  formula::World world = world_of(scene);
  data_ =
      std::shared_ptr<const Data>(new Data{std::move(scene), std::move(context), formula::Solver(std::move(world))});
}

DistanceValue World::distance(std::string_view distance, const Point& p) const {
  const formula::Objective wanted = data_->distance(distance);
  const formula::DistanceAt d =
      wanted.distance.mode == formula::Mode::kRotation
          ? data_->check(data_->formula(fmt::format("{} >= 0", distance)), real(p)).atoms.front().distance
          : data_->solver.distance_at(wanted.distance, real(p));
  std::optional<double> value = d.value;
  if (value && wanted.negated) value = -*value;
  if (value && *value == exact::kInfinity) value.reset();
  return {value, io::witness_words(d, plane::Twofold(data_->scene.grid.step()))};
}

SignMap World::sign_map(std::string_view distance, const Number& level) const {
  const formula::Objective wanted = data_->distance(distance);
  const exact::Real at = exact::Real::parse_decimal(level.text()) / data_->scene.grid.step();
  plane::SignMap map =
      formula::objective_distance(data_->solver.prepared(), wanted.distance)->sign_map(wanted.negated ? -at : at);
  if (wanted.negated) map = plane::remark(std::move(map), [](plane::Mark m) { return plane::Mark(-m); });
  return SignMap(
      std::make_shared<const SignMap::Data>(SignMap::Data{std::move(map), data_->scene.grid.step(), data_->unit()}));
}

Region World::solve(std::string_view formula) const {
  return data_->region(formula::feasible_near(data_->solver, data_->formula(formula)));
}

bool World::holds(std::string_view formula, const Point& p) const {
  return data_->check(data_->formula(formula), real(p)).holds;
}

Optimum World::minimize(std::string_view objective, std::string_view formula) const {
  const formula::Objective wanted = formula::parse_objective(objective, data_->context);
  formula::Optimum best = formula::optimize(formula::feasible_near(data_->solver, data_->formula(formula)), wanted,
                                            distance::Sense::kMinimum, data_->solver);
  return {best.value ? std::optional(best.value->to_double()) : std::nullopt, best.attained,
          data_->region(std::move(best.at))};
}

Region World::shape(const std::string& name) const {
  return data_->region(plane::build(*data_->scene.shape(name), data_->scene.grid.step_size()).region);
}

}  // namespace findspace
