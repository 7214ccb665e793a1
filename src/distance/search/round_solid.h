// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A convex set of points within a radius of a segment or a point (a ball, or what one sweeps), or of any convex set,
// for searches in doubles. A plane that touches it bounds what a search takes for it, to second order in the distance
// from where it touches. Guarantee: doubles. Keywords: capsule, sphere-swept volume, supporting plane.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "distance/search/solid_max_min.h"

namespace findspace::distance {

struct RoundSolid {
  space::Vector from, to;
  double radius = 0;
  /// Set: from a point to the nearest one of the convex core, whose box `from` and `to` are the corners of.
  std::function<space::Vector(const space::Vector&)> way{};

  space::Vector projection(const space::Vector& x) const;  // on the segment, or the core
  /// How far x is outside, negative inside.
  double beyond(const space::Vector& x) const { return space::length(x - projection(x)) - radius; }
  /// x, or the nearest place of the solid.
  space::Vector pulled_in(const space::Vector& x) const;
  /// How far the corners are beyond the plane that touches the solid where it is nearest to x; none deep inside.
  std::optional<std::array<double, 4>> beyond_plane(const space::Vector& x, const Tetrahedron& corners) const;
};

/// A vector of length 1 across the unit vector.
inline space::Vector across(const space::Vector& unit) {
  const space::Vector way =
      space::cross(unit, std::fabs(unit.x) < 0.6 ? space::Vector{1, 0, 0} : space::Vector{0, 1, 0});  // no sign: any
  return space::scaled(1 / space::length(way), way);
}

/// Tetrahedra that cover it.
std::vector<Tetrahedron> around(const RoundSolid& solid);

/// What is searched through: the union of tetrahedra and round ones.
struct Solids {
  std::vector<Tetrahedron> cells{};
  std::vector<RoundSolid> round{};
  std::vector<space::Vector> corners{};  // places that are tried first
};

}  // namespace findspace::distance
