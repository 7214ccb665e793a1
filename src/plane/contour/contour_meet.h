// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Edges of contours, and where two of them meet. Used by contour.cpp and contour_side.cpp only.
#pragma once

#include <algorithm>
#include <optional>

#include "plane/contour/shape.h"

namespace findspace::plane {

using int128 = exact::int128;

inline int128 cross(GridPoint o, GridPoint a, GridPoint b) {
  return int128(a.x - o.x) * (b.y - o.y) - int128(a.y - o.y) * (b.x - o.x);
}

/// An edge with both ends; `arc` is the circle, null for a segment.
struct Span {
  GridPoint from, to;
  const ArcCircle* arc = nullptr;
  bool ccw = true;

  /// Ends in counter-clockwise order of the arc: it is the part of its circle not to the left of first -> last.
  GridPoint first() const { return arc && !ccw ? to : from; }
  GridPoint last() const { return arc && !ccw ? from : to; }
};

inline Span span_of(const Contour& ring, std::size_t i) {
  return {ring[i].start, ring[i + 1 == ring.size() ? 0 : i + 1].start, ring[i].arc.get(), ring[i].ccw};
}

inline bool straight(const Contour& ring) {
  return std::none_of(ring.begin(), ring.end(), [](const ContourEdge& e) { return bool(e.arc); });
}

struct CommonPoint {
  double x = 0, y = 0;  // a common point, rounded, in grid steps
  bool along = false;   // a whole piece is shared
};

/// A common point of two edges other than the ends they share as neighbours: `joined` is such an end (or null),
/// `both` says that the two ends of one are the two ends of the other, both as neighbours (a ring of two edges).
std::optional<CommonPoint> meet(const Span& f, const Span& g, const GridPoint* joined, bool both);

/// Where an edge that begins at corner `k` of a ring without repeated points goes at first: +1 inside the ring, -1
/// outside, 0 along one of the two edges there. The ring does not pass the corner twice. `way`: its orientation.
int side_of_departure(const Contour& ring, int way, std::size_t k, const Span& edge);

}  // namespace findspace::plane
