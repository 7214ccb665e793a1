// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex sets summed with a stretch of a line whose ends may be missing: {x + s u : x in P, s in the stretch}. Along u
// the sum begins and ends where P does, moved by the stretch's ends; across it is P's approx, whose rim it holds. So
// what is missing lies on the planes that cross u. Guarantee: exact, of P of any dimension. Cost: the planes, and the
// hull of the projected vertices. Source: partial Minkowski operations, distances.md 7.1. Keywords: sweep, extrusion,
// approx.
#pragma once

#include "space/rays/line_pieces.h"

namespace findspace::space {

/// {s * unit : from <= s <= to}; an end may be missing. from < to.
struct Sweep {
  RealVector unit;
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
/// of the approx of the grown P is inside, as there the distance across is the radius.
void add_swept_pieces(const ConvexRegion& set, const exact::Real& radius, const Sweep& sweep,
                      std::vector<LinePiece>& pieces);

}  // namespace findspace::space
