// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets bounded by straight lines as unions of convex pieces, and back. The pieces of a closed set are closed:
// trapezoids between two vertical lines, edges and points by themselves. Those of any other set are relatively open:
// open trapezoids, the open segments between them, open edges, vertices. Guarantee: exact, the union is the set. Cost:
// slabs times edges. Source: vertical (trapezoidal) decomposition, de Berg et al., "Computational Geometry", chapter 6.
// Keywords: convex decomposition, trapezoidal map.
#pragma once

#include <span>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::planning {

/// a*x + b*y <= c, or < c if `strict`.
struct HalfPlane {
  std::int64_t a = 0, b = 0;
  exact::Real c;
  bool strict = false;
};
/// The intersection of its half-planes; an equation is two of them.
using ConvexCell = std::vector<HalfPlane>;

/// The set has no arcs.
bool is_straight(const plane::Region& region);

/// `closed`: the set is closed, and so are the pieces; else they are relatively open. Precondition:
/// is_straight(region).
std::vector<ConvexCell> convex_cells(const plane::Region& region, bool closed);

/// The convex set with these extreme points (counter-clockwise, none on a line between others): a polygon, a segment or
/// a point; closed, or its relative interior. Throws Error(kUnsupported) where a direction is not a ratio of integers
/// below 2^62.
plane::Region convex_region(std::span<const exact::RealPoint> corners, bool closed);

}  // namespace findspace::planning
