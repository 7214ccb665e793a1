// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the boundaries of two plain sets add to their Minkowski sum: for the vertices and (open) edges of a and b that
// belong to their sets, all sums of two vertices, of a vertex and an edge, and of two edges at places with parallel
// tangents. Where tangents are not parallel the sum of two edges is open; a face beside either edge covers it
// (plain_sum.h).
//
// Guarantee: exact. Cost: a curve for every pair of cells at most, and one arrangement of them.
// Source: the envelope condition of Minkowski sums; Kaul, Farouki 1995. Keywords: half-open sets, boundary attained.
#pragma once

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// The union of those sums: a set of curves and points, open where the edges are.
Region curve_sums(const Region& a, const Region& b);

}  // namespace findspace::plane
