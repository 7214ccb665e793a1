// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a rotated set B is from being free, over all angles. B keeps out of an open set O: out of int A (and A out of
// int B), or out of all that is not A. With
//     F = { s : B rotated by the angle and moved by s keeps out },
// closed, these are the signs of  min |s| - level  and  max |s| - level  over s in F; + where F is empty, of the
// greatest also where F has no end. -(the least) is the depth of an overlap, how far B protrudes from a container; the
// greatest is that of an inner touching. F may also be the s at which B does not lie in int A (the least is then the
// margin), and s be held to a way: a line through the origin or half of one.
//
// Method: F's points nearest to and farthest from the origin are projections on contact curves (contact_curves.h) or
// points where two of them meet. The signs can change only where such a point is exactly `level` away, or where a part
// of F comes into being: two curves coincide or touch, three meet in one point. All these angles are found; at each and
// between them the sign is decided from the curves' points, exactly (a filter in doubles first).
// Guarantee: exact, also where the angle is a root of degree up to 12 (rotation_polynomial.h). Cost: for every angle
// pairs of features, triples of the few that are near. Source: distances.md 3.1 and 7.2; Avnaim, Boissonnat, Faverjon,
// A practical exact motion planning algorithm for polygonal objects amidst polygonal obstacles (1988). Keywords:
// rotational penetration depth.
#pragma once

#include <optional>

#include "plane/rotation/rotated_contact.h"
#include "plane/rotation/rotated_free_events.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::plane {

class RotatedFree {
 public:
  enum class Keep { kApart, kInside, kNotWithin };
  /// B = { to + rotated(b - about) + s }, closed and bounded; A closed.
  struct Pair {
    const Region& rotating;
    const Region& fixed;
    exact::RealPoint about, to;
    /// The signs of the distance of a single point to A, and where Keep::kApart of one to B, at level 0.
    const SignMap& around_fixed;
    const SignMap& around_rotation;
  };
  RotatedFree(const Pair& pair, Keep keep, std::optional<FreeWay> way = std::nullopt);

  /// The signs at the angles of a set.
  RotationMap nearest(const exact::Real& level, const RotationMap& within = RotationMap::uniform(1)) const {
    return rotation_map(level, false, within);
  }
  RotationMap farthest(const exact::Real& level, const RotationMap& within = RotationMap::uniform(1)) const {
    return rotation_map(level, true, within);
  }

 private:
  class Look;
  bool has_no_end() const;
  RotationMap rotation_map(const exact::Real& level, bool far, const RotationMap& within) const;

  Pair pair_;
  Keep keep_;
  std::optional<FreeWay> way_;
  ContactCurves curves_;
  RoughSet rotation_, open_;
  double tolerance_;
};

}  // namespace findspace::plane
