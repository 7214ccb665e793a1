// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A 3D shape tree rotated in space: the same tree with rotated primitives, since rotations commute with all its nodes.
// Guarantee: a rotation that takes axes to axes is exact; others (rotation.h) put every vertex, and the centre of a
// ball, on the grid once, where it is not there already. What was convex stays convex (a polytope); other surfaces are
// cut into triangles before, so that they stay closed. Cost: linear. Keywords: rigid motion, orientation.
#pragma once

#include "plane/build/transform.h"
#include "space/polytope/solid.h"
#include "space/shape/rotation.h"

namespace findspace::space {

/// Throws Error(kOutOfRange) where a vertex leaves the grid, Error(kUnsupported) for a prism with arcs that is not
/// made one, Error(kGeometry) where rounding breaks a surface. `rounding` counts every point that moved.
plane::ShapePtr rotated(const plane::Shape& shape, const Rotation& rotation, plane::Rounding& rounding);

}  // namespace findspace::space
