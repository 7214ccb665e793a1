// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex sets of positions grown by balls, as searches and exact tests see them. Guarantee: whether a place belongs is
// decided exactly; distances are doubles. Keywords: offset polyhedron, sphere-swept volume.
#pragma once

#include <vector>

#include "distance/answer/answer.h"
#include "distance/search/boundary_search.h"
#include "space/body/body.h"

namespace findspace::distance {

/// The open set of what is nearer than the radius to {x : every plane < 0}, or to the centre where there are no planes.
struct GrownSet {
  std::vector<space::HalfSpace> planes;
  space::RealVector center;
  exact::Real radius;

  bool holds(const space::RealVector& p) const;
  /// The signed distance to its boundary, negative inside, and the place of the boundary nearest to p where that is
  /// known.
  Answer to_boundary(const space::RealVector& p) const;
};

/// The distance to the set less its radius; inside the set without a radius minus the depth in its planes, so that it
/// is convex.
ConvexDistance grown_distance(const GrownSet& set);

/// The distance less a radius.
TouchingConstraint less_radius(TouchingConstraint away, double radius);
/// That of a set moved by p, of which the way to the nearest place is known, with its slope.
TouchingConstraint touching_way(std::function<space::Vector(const space::Vector&)> way, const space::Vector& p,
                                double radius);
/// d(x, core) - radius of a part moved by p, with its slope.
TouchingConstraint touching_distance(const space::BodyPart& part, const space::Vector& p, double radius);

/// The same, and inside the core the depth in that and the radius: the signed distance to the boundary.
TouchingConstraint touching_boundary(const space::BodyPart& part, const space::Vector& p, double radius);

/// The highest of the planes at x: half-spaces, or in numbers.
template <class Planes>
Touching highest_of(const Planes& planes, const space::Vector& x, double inward = 0) {
  Touching best{-exact::kInfinity, {}};
  for (const auto& h : planes) {
    const double value = h.approx_value(x) + inward;
    if (value > best.value) best = {value, h.unit};
  }
  return best;
}
/// The highest of the planes, moved by p and inward by `inward`.
TouchingConstraint highest_plane(std::vector<space::HalfSpace> planes, const space::Vector& p, double inward = 0);

TouchingConstraint distance_to_point(const space::Vector& p);

/// The inside of a part.
GrownSet grown_set(const space::BodyPart& part);
/// Of the positions at which the two parts meet, the open set; of two bodies those of all pairs.
GrownSet difference(const space::BodyPart& a, const space::BodyPart& b);
std::vector<GrownSet> differences_of_parts(const space::Body& a, const space::Body& b);
/// Of the positions at which B leaves A, which has no radii: for each part of B those at which it meets what is
/// outside.
std::vector<GrownSet> differences_of_outside(const space::Body& a, const space::Body& b);

}  // namespace findspace::distance
