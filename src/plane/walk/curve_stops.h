// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where directed curves meet, in order along each: crossings of two, and degenerate vertices, where ends touch other
// curves or each other or several curves cross. Guarantee: exact. Cost: that of the pairs in a grid of cells
// (broad_phase.h), or of those given. Used by meeting_curves.cpp only.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "plane/base/arena.h"
#include "plane/walk/degenerate_vertices.h"
#include "plane/walk/directed_curves.h"

namespace findspace::plane {

/// Where another curve crosses a curve, or a degenerate vertex lies on it.
struct Stop {
  Stop() {}  // nothing yet: large lists are made, and then filled by several threads
  Stop(Index piece, Index point, Index other, bool from_right)
      : piece(piece), point(point), other(other), twin(kNone), from_right(from_right) {}

  Index piece;  // kNone: one at the same place stands for it
  Index point;
  Index other;      // the other curve; kNone at a degenerate vertex
  Index twin;       // the place of this crossing among the stops of the other curve; at a degenerate vertex its number
  bool from_right;  // the other curve passes from the right to the left
};

struct CurveStops {
  CurveStops(std::size_t points, Memory memory)
      : stops(memory), first(memory), opposite(memory), degenerate_vertices(points, memory) {}

  ArenaVector<Stop> stops;                        // along every curve
  ArenaVector<Index> first;                       // of curve i: from first[i] to first[i + 1] - 1
  ArenaVector<std::pair<Index, Index>> opposite;  // curves that run along each other, the one to the right first
  DegenerateVertices degenerate_vertices;         // settled
};

/// Adds the crossings to the geometry of `c`.
CurveStops find_stops(DirectedCurves& c, Memory memory);

/// Of these pairs alone.
CurveStops find_stops(DirectedCurves& c, std::span<const std::pair<Index, Index>> pairs, Memory memory);

}  // namespace findspace::plane
