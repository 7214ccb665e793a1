// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A world of named shapes, one of which moves by a translation p, and the questions about it: distances at a position,
// their sign maps, the region in which a formula holds, and optima over it. What is computed for one question (no-fit
// polygons, trees) is kept for the next. Errors are findspace::Error. Questions from many threads are safe. Keywords:
// configuration space, feasible region, solver.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "findspace/error.h"
#include "findspace/region.h"
#include "findspace/shape.h"

namespace findspace {

struct WorldOptions {
  std::string unit;          // um mm cm m in mil, or empty
  Number grid = "0.000001";  // all coordinates lie on this grid
};

/// The value of a distance and where it is attained.
struct DistanceValue {
  std::optional<double> value;  // nothing: undefined, +infinity
  std::string witness;          // "vertex (1, 2) of B and edge (0, 0) to (4, 0) of A", or empty
};

struct Optimum {
  std::optional<double> value;  // nothing: there is none
  bool attained = false;
  Region at;  // the best positions
};

class World {
 public:
  /// Distances are those of the shapes' closures.
  World(const std::map<std::string, Shape>& shapes, const std::string& moving, const WorldOptions& options = {});

  /// A distance in its formula text, e.g. "gamma1(B, A)", at p.
  DistanceValue distance(std::string_view distance, const Point& p) const;
  /// The sign of the distance minus the level at every position.
  SignMap sign_map(std::string_view distance, const Number& level) const;
  /// {p : the formula holds at p} (docs/formula.md).
  Region solve(std::string_view formula) const;
  bool holds(std::string_view formula, const Point& p) const;
  /// The least value of an objective (a distance, x, y, "distance to [1, 2]") where the formula holds.
  Optimum minimize(std::string_view objective, std::string_view formula = "true") const;
  /// A shape as a point set.
  Region shape(const std::string& name) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
