// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A world of named shapes, one of which moves by a translation p, and the questions about it: distances at a position,
// their sign maps, the region in which a formula holds, and optima over it. p is in the world's unit; at p = (0, 0) the
// moving shape is where it is drawn. What is computed for one question (no-fit polygons, trees) is kept for the next.
// Questions from many threads are safe. Guarantee: truths, signs and regions are exact at every real position; values
// are rounded once (docs/distances.md says of which that is not true). Cost: shapes are built by the constructor, maps
// of two shapes when they are first asked for, after that a question costs one overlay, or the work at one position.
// Errors: findspace::Error, kUnknownName and kSyntax for a formula with its line and column, kUnsupported for what is
// not computed. Source: Pustylnik, arXiv:0808.2931. Keywords: configuration space, feasible region, solver.
#pragma once

#include <concepts>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "findspace/error.h"
#include "findspace/formula.h"
#include "findspace/region.h"
#include "findspace/shape.h"

namespace findspace {

struct WorldOptions {
  std::string unit;  // um mm cm m in mil, or empty
};

/// The value of a distance, in the unit, and where it is attained.
struct DistanceValue {
  std::optional<double> value;  // nothing: undefined, +infinity
  std::string witness;          // "vertex (1, 2) of B and edge (0, 0) to (4, 0) of A", or empty
};

struct Optimum {
  std::optional<double> value;  // the infimum; nothing where the region is empty or there is no lower bound
  bool attained = false;        // a position of the region takes it
  Region at;                    // all that do; else those of the region's closure
};

class Query;

class World {
 public:
  /// `moving` is one of the names. Distances are those of the shapes' closures. Throws what is wrong with a shape:
  /// kGeometry, kBadValue, kOutOfRange, kUnknownName, kSyntax, kFile; kUnsupported for shapes of space.
  World(const std::map<std::string, Shape>& shapes, const std::string& moving, const WorldOptions& options = {});

  /// A distance in its formula text, e.g. "gamma1(B, A)" or "margin(B, A)" (docs/formula.md), at p; in degrees where it
  /// is one in rotation ("gamma1(B, A, rotating=(0, 0))").
  DistanceValue distance(std::string_view distance, const Point& p) const;
  /// The sign of the distance minus the level, in the unit, at every position. kUnsupported for those in rotation.
  SignMap sign_map(std::string_view distance, const Number& level) const;
  /// {p : the formula holds at p} (docs/formula.md). kUnsupported for formulas with distances in rotation.
  Region solve(const Formula& formula) const;
  /// Whether p is in that set, without making it.
  bool holds(const Formula& formula, const Point& p) const;
  /// The least value of an objective (a distance, x, y, "distance to [1, 2]") where the formula holds.
  Optimum minimize(std::string_view objective, const Formula& formula = "true") const;
  /// The formula, ready for many positions.
  Query query(const Formula& formula) const;
  /// What it was made of.
  const std::map<std::string, Shape>& shapes() const;
  const std::string& moving() const;
  std::string unit() const;
  /// A shape as a point set, open ends and all. kUnknownName for none of that name.
  Region shape(const std::string& name) const;

  struct Data;
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// A formula over a world, to be asked at many positions. Immutable, cheap to copy; asking from many threads is safe.
/// Guarantee: exact, as World::holds. Cost: the first question about many positions makes the region of the formula,
/// after that a position costs 10 to 100 ns; a single position makes no region.
class Query {
 public:
  bool holds(const Point& p) const;
  template <std::same_as<Position> P>
  bool holds(const P& p) const {
    return holds_at(p);
  }
  /// Of each position, with all threads; `out` is as long as `positions`.
  void holds(std::span<const Position> positions, std::span<bool> out) const;
  /// {p : the formula holds at p}.
  const Region& region() const;
  const World& world() const;
  const Formula& formula() const;
  /// The nearest feasible position, or of the closure of those; nothing where the formula holds nowhere.
  std::optional<Region::Nearest> nearest(const Position& from) const;

  struct Data;
  explicit Query(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  bool holds_at(const Position& p) const;

  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
