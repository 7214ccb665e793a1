// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A vertex of one set that lies in another one, found without preparing either: the quickest proof that two sets meet.
// The vertex taken is the one nearest to the middle of the other set's box, and whether it lies in the set is the
// parity of the boundary edges straight above it. Guarantee: what is found lies in the set; nothing is found where
// numbers cannot tell, or where only other vertices would do. Cost: O(n + m), some microseconds for 1000 vertices each.
// Keywords: point in polygon, even-odd rule, early overlap test.
#pragma once

#include <optional>

#include "plane/complex/cell_complex.h"

namespace findspace::distance {

/// A set and the box around its vertices, in numbers.
struct Boxed {
  const plane::Region& region;
  double x = 0, y = 0, half_width = 0, half_height = 0;  // its middle; half its sides
  double scale = 1;                                      // the size of the coordinates

  explicit Boxed(const plane::Region& region);
};

/// A vertex v of the closed set `of`, so that v + (dx, dy) lies in the inside of the other one.
std::optional<plane::Index> vertex_within(const Boxed& of, const Boxed& in, double dx, double dy);

}  // namespace findspace::distance
