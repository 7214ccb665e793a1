// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Worlds: made, changed, and asked.

#include "findspace/world.h"

#include <fmt/format.h>

#include <algorithm>

#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "formula/language/lexer.h"
#include "formula/language/text.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/solve_region.h"
#include "formula/planar/solve_rotation.h"
#include "formula/solid/solve_rays.h"
#include "plane/base/parallel.h"
#include "plane/build/build.h"
#include "plane/complex/overlay.h"
#include "plane/query/locate_line.h"
#include "plane/rotation/rotation_map.h"

namespace findspace {

using distance::Coordinates;
using exact::Real;

namespace {

exact::RealPoint planar(const Coordinates& p) { return {p[0], p[1]}; }
space::RealVector solid(const Coordinates& p) { return {p[0], p[1], p[2]}; }

formula::Context named_context(const std::map<std::string, Shape>& shapes, const std::vector<std::string>& moving,
                               const std::string& unit) {
  if (shapes.empty()) throw Error(ErrorCode::kBadValue, "there are no shapes");
  formula::Context context = api::context_of(shapes, unit);
  if (moving.empty()) throw Error(ErrorCode::kBadValue, "no shape moves");
  for (const std::string& name : moving)
    if (shapes.count(name) == 0) api::unknown_shape(context, name);
  context.moving = moving;
  return context;
}

/// Lists of names that the scene gave.
void leave_out(const std::string& name, formula::Context& context) {
  for (auto& [group, names] : context.groups) std::erase(names, name);
  if (context.all) std::erase(*context.all, name);
}

/// The shapes of a group that do not move.
std::vector<std::pair<std::string, Shape>> standing_of(const World::Data& data,
                                                       const std::vector<std::string>& members) {
  std::vector<std::pair<std::string, Shape>> result;
  const std::vector<std::string>& moving = data.context.moving;
  for (const std::string& name : members)
    if (std::find(moving.begin(), moving.end(), name) == moving.end()) result.emplace_back(name, data.shape(name));
  return result;
}

/// The world with one shape other than before; null: without it.
std::shared_ptr<const World::Data> changed(const World::Data& before, const std::string& name, const Shape* shape) {
  auto data = std::make_shared<World::Data>(before);
  if (shape)
    data->shapes.insert_or_assign(name, *shape);
  else
    data->shapes.erase(name);
  const formula::Context named = named_context(data->shapes, before.context.moving, before.unit());
  data->context.shapes = named.shapes;
  if (!shape) leave_out(name, data->context);
  if (shape) data->grid = api::common_grid(before.grid, shape->data().grid);
  // Parts of collections are decided by their solver alone.
  const bool parts =
      (shape && api::tree_of(*shape)->collection) || (before.planar && before.planar->world().parts.count(name) > 0);
  if (data->dimension() == 2 && !parts && data->grid.step() == before.grid.step()) {
    formula::ShapeChanges changes;
    changes[name] = shape ? std::optional(api::region_on(*shape, data->grid, name)) : std::nullopt;
    data->planar = std::make_shared<const formula::Solver>(*before.planar, std::move(changes));
  } else {
    api::make_solver(*data, &before);
  }
  return data;
}

}  // namespace

namespace api {

Coordinates place_of(const World::Data& world, const Point& p) {
  if (world.dimension() != 2) throw Error(ErrorCode::kBadValue, "a position of this world has three coordinates");
  return {real_of(p.x), real_of(p.y)};
}
Coordinates place_of(const World::Data& world, const Point3& p) {
  if (world.dimension() != 3) throw Error(ErrorCode::kBadValue, "a position of this world has two coordinates");
  return {real_of(p.x), real_of(p.y), real_of(p.z)};
}
Coordinates place_of(const World::Data& world, std::span<const double> p) {
  if (std::size_t(world.dimension()) != p.size())
    throw Error(ErrorCode::kBadValue, fmt::format("a position of this world has {} coordinates", world.dimension()));
  Coordinates out;
  for (const double c : p) out.push_back(plane::decimal_of(c));
  return out;
}

}  // namespace api

// ---- World::Data

const formula::Solver& World::Data::plane(std::string_view what) const {
  if (!planar) throw Error(ErrorCode::kUnsupported, fmt::format("{}: only in the plane", what));
  return *planar;
}

const formula::SpaceSolver& World::Data::space(std::string_view what) const {
  if (!solid) throw Error(ErrorCode::kUnsupported, fmt::format("{}: only in space", what));
  return *solid;
}

const Shape& World::Data::shape(const std::string& name) const {
  const auto found = shapes.find(name);
  if (found == shapes.end()) api::unknown_shape(context, name);
  return found->second;
}

formula::Objective World::Data::distance(std::string_view text) const {
  formula::Objective wanted = formula::parse_objective(text, context);
  if (wanted.kind != formula::Objective::Kind::kDistance)
    throw Error(ErrorCode::kBadValue, fmt::format("'{}' is not a distance of shapes", text));
  return wanted;
}

bool World::Data::holds(const formula::Formula& f, const Coordinates& p) const {
  if (solid) return solid->check(f, findspace::solid(p)).holds;
  return planar->holds(f, findspace::planar(p));
}

formula::Check World::Data::check(const formula::Formula& f, const Coordinates& p) const {
  if (solid) return solid->check(f, findspace::solid(p));
  return planar->check(f, findspace::planar(p));
}

formula::DistanceAt World::Data::value(const formula::Objective& wanted, const Coordinates& p) const {
  const auto signed_as_wanted = [&](formula::DistanceAt d) {
    return wanted.negated ? formula::minus(std::move(d)) : d;
  };
  const formula::Distance& d = wanted.distance;
  if (solid) {
    const Real& step = grid.step();
    const auto found = solid->try_value(d, space::scaled(1 / step, findspace::solid(p))).or_throw();
    return signed_as_wanted(
        formula::distance_at(formula::text(d), found ? std::optional(distance::in_scene(*found, step)) : std::nullopt));
  }
  return signed_as_wanted(planar->distance_at(d, findspace::planar(p)));
}

Region World::Data::region(plane::Region cells) const { return api::make_region(std::move(cells), grid, unit()); }

// ---- World

World::World(const std::map<std::string, Shape>& shapes, const std::string& moving, const WorldOptions& options)
    : World(shapes, std::vector{moving}, options) {}

World::World(const std::map<std::string, Shape>& shapes, const std::vector<std::string>& moving,
             const WorldOptions& options) {
  auto data = std::make_shared<Data>(Data{shapes, {}, named_context(shapes, moving, options.unit)});
  data->grid = api::grid_of(shapes);
  api::make_solver(*data);
  data_ = std::move(data);
}

void World::set(const std::string& name, const Shape& shape) { data_ = changed(*data_, name, &shape); }

void World::remove(const std::string& name) {
  data_->shape(name);
  const std::vector<std::string>& movers = data_->context.moving;
  if (std::find(movers.begin(), movers.end(), name) != movers.end())
    throw Error(ErrorCode::kBadValue, fmt::format("'{}' is the shape that moves", name));
  if (data_->motion && data_->motion->paths.count(name) > 0)
    throw Error(ErrorCode::kBadValue, fmt::format("'{}' has a path in the motion", name));
  data_ = changed(*data_, name, nullptr);
}

void World::move(const std::string& name, const Point& by) { set(name, data_->shape(name).translated(by)); }
void World::move(const std::string& name, const Point3& by) { set(name, data_->shape(name).translated(by)); }

World World::with(const ShapeGroups& groups) const {
  const auto need = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names) data_->shape(name);
  };
  std::shared_ptr<const Data> grown = data_;
  std::vector<std::string> empty;
  for (const auto& [name, members] : groups.groups) {
    need(members);
    if (data_->shapes.count(name) > 0) continue;
    const auto standing = standing_of(*data_, members);
    if (standing.empty()) {
      empty.push_back(name);
    } else {
      const Shape all = Shape::collection(standing);
      grown = changed(*grown, name, &all);
    }
  }
  if (groups.all) need(*groups.all);
  auto data = std::make_shared<Data>(*grown);
  formula::Context& context = data->context;
  for (const auto& [name, members] : groups.groups) context.groups.insert_or_assign(name, members);
  for (const std::string& name : empty)
    if (std::find(context.empty.begin(), context.empty.end(), name) == context.empty.end())
      context.empty.push_back(name);
  if (groups.all) context.all = groups.all;
  return World(std::move(data));
}

World World::with(const Options& options) const {
  auto data = std::make_shared<Data>(*data_);
  data->options = options;
  if (options.work_limit == 0) data->options.work_limit = data_->options.work_limit;
  return World(std::move(data));
}

namespace {

template <class P>
DistanceValue distance_of(const World::Data& data, std::string_view text, const P& p) {
  return api::limited(data.options,
                      [&] { return api::public_value(data.value(data.distance(text), api::place_of(data, p))); });
}
template <class P>
bool holds_of(const World::Data& data, const Formula& formula, const P& p) {
  return api::limited(data.options, [&] { return data.holds(data.formula(formula.text()), api::place_of(data, p)); });
}
template <class P>
Check check_of(const World::Data& data, const Formula& formula, const P& p) {
  return api::limited(data.options, [&] {
    return api::public_check(data.check(data.formula(formula.text()), api::place_of(data, p)));
  });
}

}  // namespace

DistanceValue World::distance(std::string_view d, const Point& p) const { return distance_of(*data_, d, p); }
DistanceValue World::distance(std::string_view d, const Point3& p) const { return distance_of(*data_, d, p); }
bool World::holds(const Formula& f, const Point& p) const { return holds_of(*data_, f, p); }
bool World::holds(const Formula& f, const Point3& p) const { return holds_of(*data_, f, p); }
Check World::check(const Formula& f, const Point& p) const { return check_of(*data_, f, p); }
Check World::check(const Formula& f, const Point3& p) const { return check_of(*data_, f, p); }

Region World::solve(const Formula& formula) const {
  const formula::Solver& solver = data_->plane("the region of a formula");
  return api::limited(data_->options, [&] {
    return data_->region(formula::exact_region(solver, data_->formula(formula.text())).or_throw());
  });
}

SignMap World::sign_map(std::string_view distance, const Number& level) const {
  const formula::Solver& solver = data_->plane("a sign map");
  const formula::Objective wanted = data_->distance(distance);
  const Real at = api::real_of(level) / data_->grid.step();
  return api::limited(data_->options, [&] {
    plane::SignMap map =
        formula::position_function(solver.prepared(), wanted.distance)->sign_map(wanted.negated ? -at : at);
    if (wanted.negated) map = plane::remark(std::move(map), [](plane::Mark m) { return plane::Mark(-m); });
    return SignMap(std::make_shared<const SignMap::Data>(std::move(map), data_->grid, data_->unit()));
  });
}

Optimum World::minimize(std::string_view objective, const Formula& formula) const {
  const formula::Solver& solver = data_->plane("an optimum");
  const formula::Objective wanted = formula::parse_objective(objective, data_->context);
  return api::limited(data_->options, [&] {
    const formula::SolvedRegion where = formula::solve_region(solver, data_->formula(formula.text()));
    formula::Optimum best = formula::optimize(solver, where, {wanted});
    Region at = data_->region(std::move(best.at));
    return api::public_optimum(best, std::move(at));
  });
}

namespace {

const formula::Solver& plane_at_rest(const World::Data& data, std::string_view what) {
  const formula::Solver& solver = data.plane(what);
  if (data.motion) throw Error(ErrorCode::kUnsupported, "an angle of shapes that move in time is not computed");
  return solver;
}

}  // namespace

std::vector<Interval> World::angles(const Formula& formula, const Point& p, const Point& about) const {
  const formula::Solver& solver = plane_at_rest(*data_, "a map of angles");
  const exact::RealPoint at = findspace::planar(api::place_of(*data_, p));
  const exact::RealPoint centre = findspace::planar(api::place_of(*data_, about));
  return api::limited(data_->options, [&] {
    const formula::Formula asked = data_->formula(formula.text());
    const formula::RotationSolver rotated(solver, {at, {}, centre});
    std::vector<Interval> out;
    for (const plane::RotationInterval& i : plane::intervals(rotated.maps(asked).feasible(asked))) {
      const auto [from, to] = i.degrees();
      out.push_back({from, to, i.from_in, i.to_in});
    }
    return out;
  });
}

Check World::check_rotated(const Formula& formula, const Point& p, const Number& degrees, const Point& about) const {
  const formula::Solver& solver = plane_at_rest(*data_, "a rotated shape");
  const exact::RealPoint at = findspace::planar(api::place_of(*data_, p));
  const exact::RealPoint centre = findspace::planar(api::place_of(*data_, about));
  return api::limited(data_->options, [&] {
    const formula::RotationSolver rotated(solver, {at, api::real_of(degrees), centre});
    return api::public_check(rotated.check(data_->formula(formula.text())));
  });
}

OnLine World::on_line(const Formula& formula, const Point3& through, const Point3& direction) const {
  const formula::SpaceSolver& solver = data_->space("positions on a line");
  const Coordinates from = api::place_of(*data_, through), along = api::place_of(*data_, direction);
  const Real& step = data_->grid.step();
  return api::limited(data_->options, [&] {
    const auto found = solver.feasible_on(data_->formula(formula.text()),
                                          {space::scaled(1 / step, findspace::solid(from)), findspace::solid(along)});
    OnLine out;
    out.exact = found.side == formula::Side::kExact;
    const auto end = [](const std::optional<Real>& t) { return t ? std::optional(t->to_double()) : std::nullopt; };
    for (const plane::LineInterval& i : plane::intervals(found.marks, step))
      out.intervals.push_back({end(i.from), end(i.to), i.from_in, i.to_in});
    return out;
  });
}

Region World::shape(const std::string& name) const {
  data_->plane("a shape as a region");
  return data_->region(api::region_on(data_->shape(name), data_->grid, name));
}

const std::map<std::string, Shape>& World::shapes() const { return data_->shapes; }
const std::string& World::moving() const { return data_->context.moving.front(); }
ShapeGroups World::groups() const {
  ShapeGroups result{data_->context.groups, data_->context.all};
  for (const std::string& name : data_->context.empty) result.groups[name];
  return result;
}
const std::vector<std::string>& World::moving_together() const { return data_->context.moving; }
std::string World::unit() const { return data_->unit(); }
int World::dimension() const { return data_->dimension(); }
const Options& World::options() const { return data_->options; }
const std::optional<Motion>& World::motion() const { return data_->motion; }
const std::optional<Number>& World::time() const { return data_->time; }

}  // namespace findspace
