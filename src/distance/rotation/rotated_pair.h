// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The T-distances of a shape B that rotates about a point and a fixed shape A, as functions of the angle: the sign of
// f(B rotated by angle, A) - level on the whole circle (distances.md 7.2). What can be said of the points of B one by
// one is reduced to a sign map M of the plane, that of a single point against A at the level:
//   gamma1 >= 0, d1:           the least mark of M that B meets;
//   gamma2, mu, h, eta1 <= 0:  the greatest one;
//   delta1 <= 0, mu and h of A to B, d*: the same with A rotated back over B.
// gamma1 below 0 (depth), eta1 and delta1 above 0, eta2 and delta2 depend on all of B at once, through corners of sums
// that move: rotated_free.h, eta1 being the depth in the complement of A, delta1 and delta2 what eta1 and eta2 are of A
// rotated back in B. Guarantee: exact, contacts at single angles and sliding ones included; where those corners decide,
// as rotated_free.h. Cost: one level map of A, then as rotated_contact.h. Units: grid steps. Keywords: rotational
// sweep, orientation, configuration space of a rotation.
#pragma once

#include "distance/planar/shape_pair.h"
#include "plane/rotation/rotated_contact.h"

namespace findspace::distance {

class RotatedPair {
 public:
  /// Closed sets, B bounded; B stands at { to + rotated(b - about) : b in B }.
  RotatedPair(plane::Region b, plane::Region a, exact::RealPoint about, exact::RealPoint to);
  /// The same, of which only the angles of a set are asked; elsewhere any signs are said.
  RotatedPair within(plane::RotationMap set) const;

  /// Whether corners of sums decide, which costs much more.
  static bool asks_for_corners(Which which, const exact::Real& level);
  plane::RotationMap sign_map(Which which, const exact::Real& level) const;
  /// Of the least signed distance of a point of B to A: at level 0 the signs of gamma1, below it of how deep single
  /// points lie, which changes no faster than the shapes. Where A has no inside, of A's points in B as well.
  plane::RotationMap nearest_point(const exact::Real& level) const;

 private:
  plane::RotationMap least(const exact::Real& level) const;
  plane::RotationMap contact(const plane::SignMap& fixed, bool back, plane::Mark (*rule)(plane::MarkSet),
                             plane::MarkSet enough) const;
  plane::RotationMap greatest(Which which, const exact::Real& level, bool back) const;
  plane::RotationMap contained(const exact::Real& level, bool back) const;
  plane::RotationMap free(const exact::Real& level, bool inside, bool back, bool farthest) const;
  plane::RotationMap cut_off(Which which, const exact::Real& level, bool negated) const;
  plane::RotationMap diameter(const exact::Real& level) const;

  plane::Region b_, a_;
  exact::RealPoint about_, to_;
  plane::RotationMap within_ = plane::RotationMap::uniform(1);
};

}  // namespace findspace::distance
