// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a set B + p protrudes from a closed set A by next to nothing, less than a search in numbers sees: the corner of
// B + p farthest from A, max over the vertices b of d(b, A). Guarantee: exact for the corners. That is the distance of
// all of B where B is a single point, and where A is a convex polygon and B has straight edges. Else the answer says
// that the distance lies between this value and `reach`. Cost: linear in both for every vertex of B outside A.
// Keywords: directed Hausdorff distance, near contact.
#pragma once

#include "distance/planar/farthest_place.h"

namespace findspace::distance {

/// Both closed and not empty; no point of B + p is farther from A than `reach`. The value may be 0.
FarthestPlace farthest_corner(const plane::Region& b, const plane::Region& a, const exact::RealPoint& p, double reach);

}  // namespace findspace::distance
