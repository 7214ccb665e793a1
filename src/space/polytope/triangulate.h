// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Polygons into triangles and into convex polygons, on their own vertices: no new point, so everything stays on the
// grid. Guarantee: exact; the triangles have the area of the polygon (checked), interiors do not meet. Cost: triangles
// near O(n log n) where few corners lie in an ear, O(n^3) at most; convex parts O(n^2) to O(n^3). Source: Meisters 1975
// (ears), Hertel and Mehlhorn 1983 (joining triangles: at most four times the least number of parts). Keywords:
// triangulation, ear clipping, convex decomposition, polygon with holes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "space/polytope/convex_polygon.h"

namespace findspace::space {

/// What to do with a vertex in the middle of a straight side.
enum class StraightCorner {
  kDrop,  // it may be left out
  kKeep   // it gets a triangle without area, so that every side of the polygon is a side of a triangle
};

/// Triangles of a simple polygon given counter-clockwise, as indices. Throws Error(kGeometry) if it is not simple.
std::vector<std::array<int, 3>> triangulate(std::span<const Point2> ring,
                                            StraightCorner straight = StraightCorner::kDrop);

/// A polygon with holes as convex parts: the outer ring counter-clockwise, holes clockwise, simple and disjoint.
std::vector<ConvexPolygon> convex_parts(const std::vector<std::vector<Point2>>& rings);

}  // namespace findspace::space
