// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Directed curves cut into the x-monotone pieces an arrangement takes. Guarantee: exact; a circle is cut at its
// leftmost and rightmost point only.
#pragma once

#include <vector>

#include "exact/planar/geometry_signs.h"
#include "plane/complex/arrangement.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// The leftmost (side = -1) or rightmost (+1) point of a circle, added.
Index extreme_point(exact::Geometry& geometry, Index circle, int side);

/// A directed arc of a circle between two of its points, cut; from == to gives the whole circle. Calls emit(from, to,
/// half, right) for each piece in turn, `half` and `right` as in RingEdge (ring_map.h).
template <class Emit>
void cut_arc(exact::Geometry& geometry, Index circle, Index from, Index to, bool ccw, Emit emit) {
  int up = exact::above_center(geometry, from, circle);
  if (up == 0) up = (exact::right_of_center(geometry, from, circle) > 0) == ccw ? 1 : -1;
  const int end_up = exact::above_center(geometry, to, circle);
  Index at = from;
  for (bool first = true;; first = false, up = -up) {
    const bool right = (up < 0) == ccw;
    // Is the end ahead on this half? Never at once when the whole circle is meant.
    bool here = end_up == up || (end_up == 0 && (exact::right_of_center(geometry, to, circle) > 0) == right);
    if (here && first) {
      const int order = exact::compare_x(geometry, to, at);
      here = right ? order > 0 : order < 0;
    }
    const Index next = here ? to : extreme_point(geometry, circle, right ? 1 : -1);
    emit(at, next, std::int8_t(up), right);
    if (here) return;
    at = next;
  }
}

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
  Index extreme(Index circle, int side) { return extreme_point(geometry, circle, side); }
};

}  // namespace findspace::plane
