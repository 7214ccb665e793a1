// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Levels of two solids of any shape, none of which is cut into convex parts: {gamma1(B, A) < level} for level > 0, and
// {eta1(B, A) < -level} with A as the complement of the solid given. The frontier of the positions where the solids
// meet lies on those facets of their convolution (ray_convolution.h) that may touch from outside, and every facet
// consists of positions where they meet. So outside, the distance to that set is the distance to the facets: the places
// nearer than the level are what a line meets of balls, cylinders and slabs about their corners, edges and faces,
// beside the overlap itself (ray_pair.h). Guarantee: exact on every line, round fronts, slits and ties included. Cost:
// that of the overlap, and some hundred nanoseconds for each piece and line in its box. Keywords: clearance, offset of
// a Minkowski sum, configuration space obstacle.
#pragma once

#include "space/convolution/ray_pair.h"
#include "space/rays/ray_sources.h"

namespace findspace::space {

/// The sign of gamma1 - level, or of eta1 + level for the complement. Coordinates in grid steps, level > 0.
RaySourcePointer clearance_rays(const Triangles& a, const Triangles& b, const exact::Real& level, const RayGrid& grid,
                                PairRays::Side side_of_a = PairRays::Side::kSolid);

}  // namespace findspace::space
