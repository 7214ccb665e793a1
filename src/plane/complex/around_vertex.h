// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The exact counter-clockwise order of the half-edges around each vertex. Curves that leave with one tangent are
// ordered by curvature. Cost: one 128-bit cross product a comparison for segments.
#pragma once

#include "exact/planar/geometry_signs.h"
#include "plane/complex/arrangement.h"

namespace findspace::plane {

/// `comes_before` for half-edges on two different lines.
inline bool line_comes_before(const exact::SupportingCurve& first, const exact::SupportingCurve& second) {
  exact::int128 left = exact::int128(first.a) * second.b, right = exact::int128(first.b) * second.a;
  return (first.b > 0) == (second.b > 0) ? left > right : left < right;
}

/// Of two different half-edges at a point that both go right (`left` false) or both left: does the first come before
/// the second, counter-clockwise from straight down or straight up? `half` as in Piece.
bool comes_before(const exact::Geometry& g, Index point, bool left, exact::Heading first, std::int8_t first_half,
                  exact::Heading second);

/// Fills out, out_start, rank and next.
void sort_around_vertices(Arrangement& a);

}  // namespace findspace::plane
