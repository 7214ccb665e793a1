// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Directed curves cut into the x-monotone pieces an arrangement takes. Guarantee: exact; a circle is cut at its
// leftmost and rightmost point only.
#pragma once

#include <vector>

#include "plane/complex/arrangement.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

class PieceBuilder {
 public:
  exact::Geometry geometry;
  std::vector<Piece> pieces;
  std::vector<char> forward;  // per piece: the directed curve runs from p0 to p1

  /// The line through two different grid points.
  Index line(const GridPoint& p, const GridPoint& q);
  /// A directed segment between two points of a line; `right`: `to` is lexicographically larger.
  void segment(Index supporting_curve, Index from, Index to, bool right);
  void segment(const GridPoint& p, const GridPoint& q);
  /// A directed arc of a circle between two of its points; from == to gives the whole circle.
  void arc(Index circle, Index from, Index to, bool ccw);
  /// An edge of a contour that goes on at `to`.
  void edge(const ContourEdge& e, const GridPoint& to);
  /// The whole circle, counter-clockwise.
  void circle(Index circle);
  /// The leftmost (side = -1) or rightmost (+1) point of a circle.
  Index extreme(Index circle, int side);
};

}  // namespace findspace::plane
