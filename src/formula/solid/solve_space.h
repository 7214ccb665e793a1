// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over a world of solid shapes: at a position (any shapes that bodies hold), and for all positions at once
// where all shapes have axis-parallel faces, or only `gamma2 -> min` is asked. The counterpart of solve.h in space.
// Guarantee: check: exact truth, Error(kUnsupported) where a value that is not an exact number is too near its level.
// feasible: the exact set, slits and points included; Error(kUnsupported) for an atom whose positions have round edges,
// with the atom's name. Keywords: feasible region, configuration space, formula, solid.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "distance/answer/optimum.h"
#include "distance/planar_least/extremum.h"
#include "distance/solid/box_maps.h"
#include "distance/solid/solid_least.h"
#include "exact/number/interval.h"
#include "formula/language/formula.h"
#include "formula/language/position_answers.h"
#include "formula/solid/lazy_body.h"
#include "formula/solid/side.h"
#include "plane/query/section.h"
#include "space/body/csg_solid.h"
#include "space/box/convex_set.h"
#include "space/convolution/ray_solids.h"

namespace findspace::formula {

struct RayWorld;
struct PreparedSpace;

/// A shape of the scene in grid steps, in the forms that it has.
struct SpaceShape {
  std::optional<space::BoxComplex> boxes;  // all faces axis-parallel: the exact set
  LazyBody body;                           // a closed body; none: `refused` says why
  std::string refused;
  std::shared_ptr<const space::CsgSolid> cut{};  // that balls are cut out of; only where there is no body
  /// Of a large mesh, or a union with one: its surfaces, for what they tell. A body that is not convex waits then.
  std::shared_ptr<const std::vector<space::RaySolid>> surfaces{};
  bool convex = false;  // of a shape with surfaces
};

exact::Tried<SpaceShape> try_space_shape(const plane::Shape& shape);
SpaceShape space_shape(const plane::Shape& shape);

struct SpaceWorld {
  std::map<std::string, SpaceShape> shapes;
  std::vector<std::string> moving;
  exact::Real step;                      // one grid step in the scene's unit
  std::shared_ptr<const RayWorld> rays;  // for signs where values are not computed; may be null
};

/// In grid steps; the direction is not zero.
struct SpaceLine {
  space::RealVector through, direction;
};

class SpaceSolver {
 public:
  explicit SpaceSolver(SpaceWorld world);
  ~SpaceSolver();

  /// `p` in the scene's unit.
  Check check(const Formula& formula, const space::RealVector& p) const;
  std::vector<DistanceAt> measure(const space::RealVector& p, const std::vector<Kind>& kinds = {}) const;

  /// One distance at p, in grid steps; nothing where it is undefined.
  std::optional<distance::Answer> value(const Distance& distance, const space::RealVector& p) const;
  exact::Tried<std::optional<distance::Answer>> try_value(const Distance& distance, const space::RealVector& p) const;

  /// Numbers between which a plain distance at a position lies (+infinity where it is undefined), quickly, in grid
  /// steps; the whole line where nothing is known so. While this lives.
  struct QuickDistance {
    std::function<exact::Interval(const space::Vector&)> within;
    bool large = false;  // of a large mesh: microseconds
  };
  QuickDistance quick_distance(const Distance& distance) const;

  /// Of `distance >= level`, a gamma1 (space_pair.h); in grid steps, as p.
  std::optional<space::RealVector> nearest_apart(const Distance& distance, const exact::Real& level,
                                                 const space::RealVector& p) const;

  /// In grid steps.
  space::BoxComplex feasible(const Formula& formula) const;
  exact::Tried<space::BoxComplex> try_feasible(const Formula& formula) const;
  /// {p : rule(signs of the formula's sign maps at p)}.
  using Rule = std::function<bool(std::span<const space::Mark>)>;
  exact::Tried<space::BoxComplex> try_region(const Formula& formula, const Rule& rule) const;
  /// The same where the formula has one distance only, whose sublevel set is a convex polytope; nothing where that is
  /// not so.
  struct ConvexMap {
    space::ConvexSet set;
    exact::Real step;  // one unit of its coordinates in the scene's unit
  };
  exact::Tried<std::optional<ConvexMap>> feasible_convex(const Formula& formula) const;
  struct OnLine {
    plane::Section marks;
    Side side = Side::kExact;  // of the true set
    plane::Section undecided;  // marks 1 where a search does not tell whether the formula holds
  };
  /// Where the formula holds along a line: marks 1, and 0 elsewhere, by the length gone from `through`, in grid steps.
  OnLine feasible_on(const Formula& formula, const SpaceLine& line) const;
  /// The first `distance -> min` of the formula, if it has one.
  std::optional<distance::OptimumOf<space::BoxComplex>> minimum_of(const Formula& formula) const;
  /// The least value of a distance over all positions, as far as it is known; nothing where it is undefined. In the
  /// scene's unit.
  std::optional<distance::Answer> nearly_least(const Distance& distance) const;
  exact::Tried<std::optional<distance::Answer>> try_nearly_least(const Distance& distance) const;

  const SpaceWorld& world() const;

 private:
  std::unique_ptr<const PreparedSpace> space_;
};

/// `p` in the scene's unit. Refused where the region is neither made of boxes nor a convex polytope and contacts do not
/// decide.
TriedNearest nearest_feasible(const SpaceSolver& solver, const Formula& formula, const space::RealVector& p);

/// Of x, y, z or the distance to a point over a region of boxes; `step` as SpaceWorld::step.
distance::OptimumOf<space::BoxComplex> optimize(const space::BoxComplex& region, const exact::Real& step,
                                                const Objective& objective, distance::Sense sense);

}  // namespace findspace::formula
