// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex hulls without interior, about which a ball makes a solid: a segment (then it is a capsule), a polygon (a disc
// with a round rim, a pillow). Guarantee: exact. Cost: n log n in the points. Keywords: capsule, stadium, pill,
// sphere-swept volume.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::space {

/// The corners of the hull of points that lie in one plane: one point, the two ends of a segment, or a polygon's in
/// circular order. Nothing for points that enclose a volume.
std::optional<std::vector<Point>> flat_corners(std::span<const Point> points);

/// The hull of two or more such corners is {x : every plane <= 0}.
std::vector<HalfSpace> flat_planes(std::span<const Point> corners);

}  // namespace findspace::space
