// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A body of the plane as a finite union of round-cornered convex parts: a convex polygon or a point, its core, grown by
// a disc of radius >= 0. Polygons have radius 0, discs are points with a radius. Parts of a union stay apart as they
// are stated; a polygon that is not convex is cut on its own vertices (triangulate.h); offsets outwards, sums, and
// hulls of equal radii keep their cores. Guarantee: exact: the union of the parts is the closure of the shape. Vertices
// off the grid are reached by multiplying all coordinates by the least number that makes them whole, `scale`; where
// there is none (irrational vertices, or more than 2^40 steps), and for arcs that bound no such part, the answer is
// nothing. Cost: that of building the shape, O(n^2) to O(n^3) for a polygon of n vertices. Source: phi.md 7, 10.
// Keywords: convex decomposition, rounded polygon, stadium.
#pragma once

#include <optional>
#include <vector>

#include "exact/number/real.h"
#include "plane/contour/shape.h"
#include "space/polytope/convex_polygon.h"

namespace findspace::space {

struct PlanarPart {
  ConvexPolygon core;
  exact::Real radius;  // in the same steps; > 0 where the core is a point
};

struct PlanarParts {
  std::vector<PlanarPart> parts;
  std::int64_t scale = 1;  // coordinates are in grid steps / scale
};

/// Of the closure of a 2D shape. Throws Error(kGeometry) where that is not a body: empty, unbounded, or with parts that
/// have no interior. `step`: size of a grid step, for the places that errors name.
std::optional<PlanarParts> planar_parts(const plane::Shape& shape, double step = 1);

/// The same parts at a scale that is a multiple of theirs; nothing beyond 2^40 steps.
std::optional<std::vector<PlanarPart>> at_scale(const PlanarParts& parts, std::int64_t scale);

}  // namespace findspace::space
