// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// include/findspace/region.h and world.h: a scene made of the shapes' texts, and a solver over it.

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "api/values/region_data.h"
#include "api/values/shape_data.h"
#include "findspace/world.h"
#include "formula/language/parse.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/optimize.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/solve_rotation.h"
#include "io/text/scene_reader.h"
#include "io/write/write_witness.h"
#include "plane/build/build.h"
#include "plane/complex/overlay.h"
#include "plane/query/in_order.h"

namespace findspace {

struct World::Data {
  std::map<std::string, Shape> shapes;
  plane::Grid grid;
  std::optional<formula::Unit> length;  // the unit
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
  std::string unit() const { return length ? std::string(formula::name(*length)) : ""; }
  Region region(plane::Region r) const;
};

namespace {

exact::RealPoint real(const Point& p) { return {api::real_of(p.x), api::real_of(p.y)}; }

plane::Grid grid_of(const std::map<std::string, Shape>& shapes) {
  std::optional<plane::Grid> grid;
  for (const auto& [name, shape] : shapes) {
    if (shape.dimension() != 2) throw Error(ErrorCode::kUnsupported, "a world of three dimensions", name);
    grid = grid ? api::common_grid(*grid, shape.data().grid) : shape.data().grid;
  }
  return grid.value_or(plane::Grid());
}

plane::Region region_on(const Shape& shape, const plane::Grid& grid) {
  if (shape.data().grid.step() == grid.step()) return shape.region().data().cells;
  return plane::build(*api::tree_on(shape, grid), grid.step_size()).region;
}

formula::World world_of(const std::map<std::string, Shape>& shapes, const std::string& moving,
                        const plane::Grid& grid) {
  formula::World world;
  for (const auto& [name, shape] : shapes) {
    try {
      const bool same = shape.data().grid.step() == grid.step();
      world.shapes.emplace(
          name, same ? shape.region().data().cells : plane::build(*api::tree_on(shape, grid), grid.step_size()).region);
    } catch (const Error& e) {
      throw e.within(fmt::format("shape '{}'", name));
    }
  }
  world.moving = {moving};
  world.step = grid.step();
  return world;
}

formula::Context context_of(const std::map<std::string, Shape>& shapes, const std::string& moving,
                            std::optional<formula::Unit> unit) {
  formula::Context context;
  for (const auto& [name, shape] : shapes) context.shapes.push_back(name);
  if (std::find(context.shapes.begin(), context.shapes.end(), moving) == context.shapes.end())
    throw Error(ErrorCode::kUnknownName,
                fmt::format("there is no shape '{}' to move{}", moving, io::choice("shapes", moving, context.shapes)));
  context.moving = {moving};
  context.unit = unit;
  return context;
}

}  // namespace

Region World::Data::region(plane::Region r) const { return api::make_region(std::move(r), grid, unit()); }

World::World(const std::map<std::string, Shape>& shapes, const std::string& moving, const WorldOptions& options) {
  const plane::Grid grid = grid_of(shapes);
  const auto unit = options.unit.empty() ? std::nullopt : std::optional(io::parse_unit(options.unit));
  formula::Context context = context_of(shapes, moving, unit);
  data_ = std::shared_ptr<const Data>(
      new Data{shapes, grid, unit, std::move(context), formula::Solver(world_of(shapes, moving, grid))});
}

DistanceValue World::distance(std::string_view distance, const Point& p) const {
  const formula::Objective wanted = data_->distance(distance);
  const formula::DistanceAt d =
      wanted.distance.mode == formula::Mode::kRotation
          ? data_->check(data_->formula(fmt::format("{} >= 0", distance)), real(p)).atoms.front().distance
          : data_->solver.distance_at(wanted.distance, real(p));
  return {(wanted.negated ? formula::minus(d) : d).value(), io::witness_words(d)};
}

SignMap World::sign_map(std::string_view distance, const Number& level) const {
  const formula::Objective wanted = data_->distance(distance);
  const exact::Real at = exact::Real::parse_decimal(level.text()) / data_->grid.step();
  plane::SignMap map =
      formula::position_function(data_->solver.prepared(), wanted.distance)->sign_map(wanted.negated ? -at : at);
  if (wanted.negated) map = plane::remark(std::move(map), [](plane::Mark m) { return plane::Mark(-m); });
  return SignMap(std::make_shared<const SignMap::Data>(SignMap::Data{std::move(map), data_->grid, data_->unit()}));
}

Region World::solve(const Formula& formula) const {
  return data_->region(formula::feasible_near(data_->solver, data_->formula(formula.text())));
}

bool World::holds(const Formula& formula, const Point& p) const {
  return data_->check(data_->formula(formula.text()), real(p)).holds;
}

Optimum World::minimize(std::string_view objective, const Formula& formula) const {
  const formula::Objective wanted = formula::parse_objective(objective, data_->context);
  formula::Optimum best = formula::optimize(formula::feasible_near(data_->solver, data_->formula(formula.text())),
                                            wanted, distance::Sense::kMinimum, data_->solver);
  return {best.value ? std::optional(best.value->to_double()) : std::nullopt, best.attained,
          data_->region(std::move(best.at))};
}

Region World::shape(const std::string& name) const {
  const auto found = data_->shapes.find(name);
  if (found == data_->shapes.end())
    throw Error(ErrorCode::kUnknownName,
                fmt::format("unknown shape '{}'{}", name, io::choice("shapes", name, data_->context.shapes)));
  return data_->region(region_on(found->second, data_->grid));
}

const std::map<std::string, Shape>& World::shapes() const { return data_->shapes; }
const std::string& World::moving() const { return data_->context.moving.front(); }
std::string World::unit() const { return data_->unit(); }

Query World::query(const Formula& formula) const {
  return Query(std::make_shared<const Query::Data>(*this, formula, data_->formula(formula.text())));
}

// ---- queries

/// The region of a formula is made when first many positions are asked.
struct Query::Data {
  World world;
  Formula written;
  formula::Formula formula;
  mutable std::once_flag made{};
  mutable std::optional<Region> known{};

  Data(World w, Formula text, formula::Formula f)
      : world(std::move(w)), written(std::move(text)), formula(std::move(f)) {}
  const Region& region() const {
    std::call_once(made, [&] { known = world.data().region(formula::feasible_near(world.data().solver, formula)); });
    return *known;
  }
  exact::RealPoint exactly(const Position& p) const { return {plane::decimal_of(p[0]), plane::decimal_of(p[1])}; }
};

bool Query::holds(const Point& p) const { return data_->world.data().check(data_->formula, real(p)).holds; }
bool Query::holds_at(const Position& p) const {
  return data_->world.data().check(data_->formula, data_->exactly(p)).holds;
}
void Query::holds(std::span<const Position> positions, std::span<bool> out) const {
  data_->region().contains(positions, out);
}
const World& Query::world() const { return data_->world; }
const Formula& Query::formula() const { return data_->written; }
const Region& Query::region() const { return data_->region(); }

std::optional<Region::Nearest> Query::nearest(const Position& from) const {
  const World::Data& world = data_->world.data();
  const auto found = world.solver.nearest_feasible(data_->formula, data_->exactly(from));
  if (!found) return std::nullopt;
  return Region::Nearest{
      {found->at.at(0).to_double(), found->at.at(1).to_double()}, found->distance.to_double(), found->attained};
}

}  // namespace findspace
