// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A 3D shape tree rotated about a line parallel to an axis: the same tree with rotated primitives, since rotations
// commute with all its nodes. Guarantee: multiples of 90 degrees are exact; other angles put every vertex (and the
// centre of a ball) on the grid once, by a turn whose sine and cosine are within 2^-60 of the true ones. What was
// convex stays convex (a polytope); other surfaces are cut into triangles before, so that they stay closed. Cost:
// linear. Keywords: rigid motion, orientation.
#pragma once

#include "exact/planar/angle.h"
#include "plane/build/transform.h"
#include "space/polytope/real_vector.h"
#include "space/polytope/solid.h"

namespace findspace::space {

/// x -> turn(x) + by, the turn about the axis `axis` (0 x, 1 y, 2 z) through the origin.
struct Rotation {
  int axis = 2;
  exact::ExactAngle turn;
  bool quarters = true;  // a multiple of 90 degrees
  RealVector by;

  /// Counter-clockwise seen from the axis' positive end, about the line through `about`.
  static Rotation about_axis(int axis, const exact::Real& degrees, const Point& about);
  RealVector linear(const RealVector& x) const;
  RealVector operator()(const RealVector& x) const { return plus(linear(x), by); }
};

/// Throws Error(kOutOfRange) where a vertex leaves the grid, Error(kUnsupported) for a prism with arcs that is not
/// made one, Error(kGeometry) where rounding breaks a surface. `rounding` counts every point that moved.
plane::ShapePtr rotated(const plane::Shape& shape, const Rotation& rotation, plane::Rounding& rounding);

}  // namespace findspace::space
