// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map of the Minkowski sum of two convex polygons: -1 inside, 0 on the boundary, +1 outside. Their convolution
// is one convex ring, the edges of both in the order of their directions. Guarantee: exact. Cost: O(n + m), no
// arrangement. Source: de Berg et al., Computational Geometry, section 13.3. Keywords: edge merging.
#pragma once

#include "plane/grid/grid_faces.h"

namespace findspace::plane {

/// An operand: a convex face (GridFace::is_convex) and the geometry of its supporting_curves.
struct ConvexOperand {
  const GridFace& face;
  const exact::Geometry& geometry;
};

SignMap convex_sum(ConvexOperand a, ConvexOperand b);

}  // namespace findspace::plane
