// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Lines through grid points whose normals are made primitive, and whose filters are made, when it is known which of
// them are needed: a union drops many. Guarantee: every sign of geometry_signs.h about them is exact, some without a
// filter; parallel lines may have different normals. Once reduced they are the lines, and their crossings the points,
// that Geometry makes at once, number by number. Cost: a tenth of a line that is made at once.
#pragma once

#include <span>

#include "exact/planar/geometry.h"

namespace findspace::exact {

/// The line through two different grid points, |x|, |y| <= 2^40; of its normal only the sign is canonical.
inline void set_unreduced_line(SupportingCurve& line, std::int64_t x, std::int64_t y, std::int64_t to_x,
                               std::int64_t to_y) {
  const bool flipped = to_y < y || (to_y == y && to_x > x);
  line.a = flipped ? y - to_y : to_y - y;
  line.b = flipped ? to_x - x : x - to_x;
  line.c = int128(line.a) * x + int128(line.b) * y;
}

inline bool are_parallel(const SupportingCurve& line, const SupportingCurve& other) {
  return int128(line.a) * other.b == int128(other.a) * line.b;
}

/// Reduces lines, all of them grid lines, and makes their filters; then approximates crossings of such lines anew. Some
/// may come twice.
void reduce_lines(Geometry& geometry, std::span<const std::uint32_t> lines, std::span<const std::uint32_t> crossings);

}  // namespace findspace::exact
