// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What Clipper is given: the signed convolution of two polygons as closed cycles, convex parts, and sums of convex
// polygons. Independent of the library's own code, as a rival should be. Source: Guibas, Ramshaw, Stolfi 1983; Hertel,
// Mehlhorn 1983.
#pragma once

#include <vector>

#include "inputs.h"

namespace bench {

/// The cycles of the signed convolution of a and b; their winding number is positive exactly where the sum has its
/// interior.
std::vector<Polygon> convolution_cycles(const Polygon& a, const Polygon& b);

/// Convex polygons that tile p: ears cut off, diagonals dropped where both ends stay convex.
std::vector<Polygon> convex_parts(const Polygon& p);

/// The sum of convex polygons, by merging their edges.
Polygon convex_sum(const Polygon& a, const Polygon& b);

}  // namespace bench
