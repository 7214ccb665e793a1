// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex sets summed with a stretch of a line whose ends may be missing: {x + s u : x in P, s in the stretch}. Along u
// the sum begins and ends where P does, moved by the stretch's ends; across it is P's shadow, whose rim it holds. So
// what is missing lies on the planes that cross u. Guarantee: exact, of P of any dimension. Cost: the planes, and the
// hull of the projected vertices. Source: partial Minkowski operations, distances.md 7.1. Keywords: sweep, extrusion,
// shadow.
#pragma once

#include "space/line_pieces.h"

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

}  // namespace findspace::space
