// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex sets summed with a stretch of a line whose ends may be missing: {x + s u : x in P, s in the stretch}. Along u
// the sum begins and ends where P does, moved by the stretch's ends; across it is P's shadow, whose rim it holds. So
// what is missing lies on the planes that cross u. Guarantee: exact, of P of any dimension. Cost: the planes, and the
// pairs of those that meet. Source: partial Minkowski operations, distances.md 7.1; Fourier and Motzkin. Keywords:
// sweep, extrusion, shadow.
#pragma once

#include <utility>
#include <vector>

#include "space/rays/line_pieces.h"

namespace findspace::space {

/// Two directions at right angles to it and to each other, of any length.
std::pair<RealVector, RealVector> axes_across(const RealVector& way);

/// {s * way : from <= s <= to}; an end may be missing. from < to.
struct Sweep {
  RealVector way;
  exact::Real from, to;
  bool from_in = true, to_in = true;
};

/// P itself, not empty; its inner points are those of its interior.
LinePiece whole_piece(const ConvexRegion& set);

/// P is not empty. The piece's inner points are those of the sum without its missing ends.
LinePiece swept_piece(const ConvexRegion& set, const Sweep& sweep);
LinePiece swept_piece(const HalfSpace& set, const Sweep& sweep);

/// The same sum for P grown by a ball, as a union of pieces: P itself swept, its round pieces at either end, and along
/// the way cylinders and slabs about its vertices, edges and the facets that hold the direction. What lies on the rim
/// of the shadow of the grown P is inside, as there the distance across is the radius.
void add_swept_pieces(const ConvexRegion& set, const exact::Real& radius, const Sweep& sweep,
                      std::vector<LinePiece>& pieces);

}  // namespace findspace::space
