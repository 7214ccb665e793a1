// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public World: shapes on one grid, the names that formulas may use, and the solver of the plane
// or of space. Positions are coordinates in the world's unit, two or three. Threads: safe.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "api/values/limits.h"
#include "api/values/shape_data.h"
#include "findspace/world.h"
#include "formula/language/parse.h"
#include "formula/planar/solve.h"
#include "formula/solid/solve_space.h"

namespace findspace {

struct World::Data {
  std::map<std::string, Shape> shapes;
  plane::Grid grid;
  formula::Context context;
  Options options{};
  std::optional<Motion> motion{};                   // in the plane
  std::optional<Number> time{};                     // of the motion
  std::shared_ptr<const formula::Solver> planar{};  // one of these two
  std::shared_ptr<const formula::SpaceSolver> solid{};

  int dimension() const { return context.dimension; }
  std::string unit() const { return context.unit ? std::string(formula::name(*context.unit)) : ""; }
  /// kUnsupported in space.
  const formula::Solver& plane(std::string_view what) const;
  const formula::SpaceSolver& space(std::string_view what) const;
  /// kUnknownName.
  const Shape& shape(const std::string& name) const;

  formula::Formula formula(std::string_view text) const { return formula::parse_formula(text, context); }
  /// Throws where the text is a coordinate or no objective at all.
  formula::Objective distance(std::string_view text) const;

  bool holds(const formula::Formula& f, const distance::Coordinates& p) const;
  formula::Check check(const formula::Formula& f, const distance::Coordinates& p) const;
  formula::DistanceAt value(const formula::Objective& wanted, const distance::Coordinates& p) const;
  /// That of a region of the plane.
  Region region(plane::Region cells) const;
};

namespace api {

/// What formulas over the shapes may speak of; nothing moves yet. kBadValue for shapes of both dimensions, kUnknownName
/// for no unit. There is a shape.
formula::Context context_of(const std::map<std::string, Shape>& shapes, const std::string& unit);
[[noreturn]] void unknown_shape(const formula::Context& context, const std::string& name);
/// One that holds all shapes; there is a shape.
plane::Grid grid_of(const std::map<std::string, Shape>& shapes);
/// A shape of the plane on a grid; errors name it.
plane::Region region_on(const Shape& shape, const plane::Grid& grid, const std::string& name);
/// Where it is not computed, `refused` says why: its surface may do.
formula::SpaceShape solid_on(const plane::Shape& tree);
/// kBadValue, kUnknownName for what is not a motion of these shapes; in steps of the grid.
formula::Motion motion_of(const World::Data& world, const Motion& motion);
/// The solver of the data, which has all but that. Shapes of `before` whose trees are the same are taken over.
void make_solver(World::Data& data, const World::Data* before = nullptr);

/// kBadValue for as many coordinates as the world has not.
distance::Coordinates place_of(const World::Data& world, const Point& p);
distance::Coordinates place_of(const World::Data& world, const Point3& p);
/// The decimals that doubles stand for.
distance::Coordinates place_of(const World::Data& world, std::span<const double> p);

/// What the two points of a witness lie on; none where that is not known.
std::vector<Feature> features_of(const formula::DistanceAt& d);
/// Throws Error(kUnsupported) for a value that is refused.
DistanceValue public_value(const formula::DistanceAt& d);
Optimum public_optimum(const distance::OptimalValue& best, Region at);
Check public_check(const formula::Check& check);

}  // namespace api
}  // namespace findspace
