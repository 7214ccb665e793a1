// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A 3D shape tree on the lines of a grid: constructive solid geometry evaluated line by line. Solids are closed; union,
// intersection, difference and complement are the plain set operations, so open ends survive; translate, mirror; hull,
// minkowski_sum and offset as body.h makes them; closure and regularize where they change nothing. Guarantee: exact on
// every line (distances.md 8.2). Cost: the pieces of the solids, merged at every node. Keywords: CSG, ray casting,
// boundary evaluation, dexel.
#pragma once

#include "plane/shape.h"
#include "space/ray_sources.h"

namespace findspace::space {

/// -1 in the set, +1 elsewhere. Throws Error(kUnsupported) for nodes that lines cannot tell: interior, boundary.
RaySourcePointer shape_rays(const plane::Shape& shape, const RayGrid& grid);

/// A box on the grid that holds the frontier of the set.
struct ShapeBox {
  Point low, high;
  bool unbounded = false;  // the set goes on beyond it
};
ShapeBox shape_box(const plane::Shape& shape);

}  // namespace findspace::space
