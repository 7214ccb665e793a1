// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Two points of bounded sets that are farthest from each other: gamma2 at one position, and the diameter of a set.
// Guarantee: the value is exact for the pair found, pairs that agree to 1e-13 relative may be exchanged. Cost: O(n log n) for
// the hulls, then the product of their sizes. Keywords: farthest pair, diameter, rotating calipers.
#pragma once

#include "plane/cell_complex.h"
#include "plane/locate.h"

namespace findspace::distance {

struct FarthestPair {
  exact::Real distance;
  exact::RealPoint first, second;        // the points; the second lies in B + p
  plane::Cell first_cell, second_cell;   // vertices or arcs of A and of B
};

/// max |a - b| over a in A, b in B + p; closed, bounded and not empty.
FarthestPair farthest_pair(const plane::Region& a, const plane::Region& b, const exact::RealPoint& p);

}  // namespace findspace::distance
