// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The convex hull of a plain set: hull(S) = all convex combinations of points of S. An open set has an open hull, a
// closed bounded one a closed hull; in general the hull is the interior of the hull of the closure, with every extreme
// point that belongs to S, and on each straight side the segment between the outermost points of S. An unbounded region
// (it holds everything far away) has the plane as its hull.
//
// Guarantee: exact, arcs stay arcs. Refused with Error(kUnsupported): a hull with a straight side whose direction is no
// integer vector of at most 2^41, because lines have integer normals here. Such sides arise as tangents of circles with
// different radii, or from a corner to a circle, and between computed corners; hulls of polygons, of chains and points
// of the grid, and of discs with one radius have none. Cost: O(n log n) and, for k arcs that may lie on the hull, k
// times its size. Source: Jarvis 1973 (gift wrapping) over circles; Andrew 1979 for the points. Keywords: convex hull,
// convex closure, rubber band.
#pragma once

#include "exact/number/tried.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// `step`: size of a grid step, for the place of a refusal.
exact::Tried<Region> try_hull(const Region& set, double step = 1);
/// The same; the error instead of the refusal.
Region hull(const Region& set, double step = 1);

}  // namespace findspace::plane
