// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A convex set of positions without overlap about a given one: half-planes that keep the no-fit polygon out. The
// nearest edge that is left gives its line, or the line across the way to its end; edges that the half-planes shut out
// need none. Guarantee: in exact arithmetic the interior of the set meets no edge of the polygon within the reach.
// Cost: edges within reach, for each half-plane. Source: greedy inflation of polytopes (IRIS), Deits & Tedrake 2014.
// Keywords: separating piece, phi-function, convex decomposition of free space.
#pragma once

#include <vector>

#include "packing/nfp/no_fit_polygon.h"

namespace findspace::packing {

/// The points p with dot(normal, p) >= offset; the normal has length 1.
struct HalfPlane {
  Vec normal;
  double offset = 0;
};

/// Keeps within `reach` of `at` in each coordinate, which is not inside the polygon. `size`: of the whole.
void free_half_planes(const NoFitPolygon& polygon, Vec at, double reach, double size, std::vector<HalfPlane>& result);

}  // namespace findspace::packing
