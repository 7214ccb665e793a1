// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether the interiors of two polygons meet. Closed sets that only touch do not count, nor does a part that fits its
// hole without clearance. They meet where two edges cross, where the sectors of all rings at a common point of the
// boundaries have a direction in common, or where a vertex of one lies inside the other; without these one cannot enter
// the other. Guarantee: exact, by signs of lattice points alone. Cost: pairs of edges whose boxes meet, and all edges
// at a contact. Keywords: interior intersection, collision test, weakly simple contact.
#pragma once

#include "packing/problem/problem.h"

namespace findspace::packing {

bool interiors_meet(const Polygon& a, const Polygon& b);

/// Whether two polygons whose interiors do not meet are nearer than `distance`.
bool are_nearer(const Polygon& a, const Polygon& b, int128 distance);

/// Whether edges of two polygons have more than a point in common.
bool run_along(const Polygon& a, const Polygon& b);

/// Whether two sets are farther apart than `distance` for certain, each in or on the rings of a polygon: where the
/// winding number is not 0. Rings may cross themselves and each other.
bool are_apart(const Polygon& a, const Polygon& b, int128 distance);

/// +1 strictly inside, 0 on the boundary, -1 outside.
int side_of(const Polygon& shape, const LatticePoint& point);

}  // namespace findspace::packing
