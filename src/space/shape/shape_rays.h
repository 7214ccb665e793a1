// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A 3D shape tree on the lines of a grid: constructive solid geometry evaluated line by line. Solids are closed; union,
// intersection, difference and complement are the plain set operations, so open ends survive; translate, mirror; hull,
// minkowski_sum and offset outwards as body.h makes them; minkowski_difference and offset inwards, sheets included
// (erosion.h; solids and what is cut out of them shrink by their true surfaces); interior, closure, boundary and
// regularize of solids and of what is made of open or of closed sets. Meshes and prisms are taken by their surfaces.
// Guarantee: exact on every line (distances.md 8.2). Cost: the faces or pieces of the solids a line meets, merged at
// every node. Keywords: CSG, ray casting, boundary evaluation, dexel.
#pragma once

#include "plane/contour/shape.h"
#include "space/rays/ray_sources.h"

namespace findspace::space {

/// -1 in the set, +1 elsewhere. Throws Error(kUnsupported) for nodes that lines cannot tell: the interior of a union,
/// the closure of an open set that is not an interior of a solid. With `by` (in grid steps) other than 0 a bound of the
/// set: for by > 0 it holds every place within `by` of the set, for by < 0 only places of the set with all within -by
/// of them. Solids and balls are grown and shrunk truly, complements and what is taken away the other way; so of unions
/// and intersections the bounds are no tighter than those of their parts.
RaySourcePointer shape_rays(const plane::Shape& shape, const RayGrid& grid, const exact::Real& by = {});

/// A box on the grid that holds the frontier of the set.
struct ShapeBox {
  Point low, high;
  bool unbounded = false;  // the set goes on beyond it
};
ShapeBox shape_box(const plane::Shape& shape);

}  // namespace findspace::space
