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
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "distance/planar_least/extremum.h"
#include "distance/solid/box_pair.h"
#include "distance/solid/solid_least.h"
#include "formula/language/formula.h"
#include "formula/solid/lazy_body.h"
#include "formula/solid/side.h"
#include "plane/query/section.h"
#include "space/body/csg_solid.h"
#include "space/box/convex_set.h"
#include "space/convolution/ray_solids.h"

namespace findspace::formula {

struct LineSigns;
struct RayWorld;
class SpacePair;

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

using SpacePlace = std::array<double, 3>;

/// One distance at one position; lengths and places in the scene's unit.
struct SpaceDistanceAt {
  std::string text;
  std::optional<double> value;  // nothing: undefined, +infinity, or refused
  std::optional<SpacePlace> nearest;
  std::optional<std::array<SpacePlace, 2>> points;  // of the first shape and of the second one
  std::string refused;                              // why it is not computed
  distance::Way way = distance::Way::kNone;         // how the value, or else the sign, was found
};

struct SpaceAtomAt {
  Atom atom;
  SpaceDistanceAt distance;
  bool holds = false;
  std::optional<double> lacks;  // as AtomAt::lacks
};

struct SpaceNearest {
  space::RealVector at;  // this and the distance in the scene's unit
  exact::Real distance;
  bool attained = false;  // it is feasible itself, not only others as near to it as you like
};

struct SpaceOptimum {
  std::optional<exact::Real> value;  // in the scene's unit
  bool unbounded = false, attained = false;
  space::BoxComplex at;
};

/// In grid steps; the direction is not zero.
struct SpaceLine {
  space::RealVector through, direction;
};

class SpaceSolver {
 public:
  explicit SpaceSolver(SpaceWorld world);
  ~SpaceSolver();

  struct Check {
    bool holds = false;
    std::vector<SpaceAtomAt> atoms;
  };
  /// `p` in the scene's unit.
  Check check(const Formula& formula, const space::RealVector& p) const;
  /// `p` in the scene's unit. Nothing if there is none, or the region is neither made of boxes nor a convex polytope.
  std::optional<SpaceNearest> nearest_feasible(const Formula& formula, const space::RealVector& p) const;
  std::vector<SpaceDistanceAt> measure(const space::RealVector& p) const;

  /// One distance at p, in grid steps; nothing where it is undefined.
  std::optional<distance::Answer> value(const Distance& distance, const space::RealVector& p) const;
  exact::Tried<std::optional<distance::Answer>> try_value(const Distance& distance, const space::RealVector& p) const;

  /// In grid steps.
  space::BoxComplex feasible(const Formula& formula) const;
  exact::Tried<space::BoxComplex> try_feasible(const Formula& formula) const;
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
  };
  /// Where the formula holds along a line: marks 1, and 0 elsewhere, by the length gone from `through`, in grid steps.
  OnLine feasible_on(const Formula& formula, const SpaceLine& line) const;
  /// The first `distance -> min` of the formula, if it has one.
  std::optional<SpaceOptimum> minimum_of(const Formula& formula) const;
  /// The least value of a distance over all positions, as far as it is known; nothing where it is undefined. In the
  /// scene's unit.
  std::optional<distance::Answer> nearly_least(const Distance& distance) const;
  exact::Tried<std::optional<distance::Answer>> try_nearly_least(const Distance& distance) const;
  /// Of x, y, z or the distance to a point over the region.
  SpaceOptimum optimize(const space::BoxComplex& region, const Objective& objective, distance::Sense sense) const;

  const SpaceWorld& world() const { return world_; }

 private:
  struct Cache;
  struct Named {
    std::shared_ptr<const SpacePair> pair;
    distance::Which which;
  };

  struct SignedValue {
    SpaceDistanceAt shown;
    int sign = 0;
  };

  exact::Tried<Named> named(const Distance& distance) const;
  /// Of a distance along an axis.
  struct Axial {
    Named plain;
    int axis = 0, way = 0;
  };
  exact::Tried<Axial> axial(const Distance& distance) const;
  exact::Tried<SignedValue> signed_value(const SignMap& map, const space::RealVector& p) const;
  SpaceDistanceAt shown(const Distance& distance, const std::optional<distance::Answer>& value) const;
  exact::Tried<SignedValue> minimal(const SignMap& map, const space::RealVector& p) const;
  /// The sign of a distance minus its level, given its value.
  exact::Tried<int> sign(const SignMap& map, const std::optional<distance::Answer>& value) const;
  exact::Tried<space::BoxComplex> sign_map(const SignMap& map) const;
  exact::Tried<distance::BoxPair::Least> least(const Distance& distance) const;
  exact::Tried<space::BoxComplex> directional_map(const SignMap& map) const;
  /// Nothing where it is undefined or -infinity; refused but of boxes along an axis.
  exact::Tried<std::optional<distance::BoxPair::Least>> directional_least(const Distance& distance) const;
  exact::Tried<std::optional<distance::Answer>> directional_nearly_least(const Distance& distance) const;
  exact::Tried<std::optional<distance::Answer>> convex_directional_least(const Distance& distance) const;
  exact::Tried<bool> takes_least(const Distance& distance, const std::optional<distance::Answer>& v,
                                 const space::RealVector& p) const;
  /// The signs of one sign map along a line, as feasible_on().
  exact::Tried<LineSigns> signs_on(const SignMap& map, const SpaceLine& line) const;
  exact::Tried<std::optional<distance::Answer>> directional_value(const Distance& distance,
                                                                  const space::RealVector& p) const;

  SpaceWorld world_;
  std::unique_ptr<Cache> cache_;
};

}  // namespace findspace::formula
