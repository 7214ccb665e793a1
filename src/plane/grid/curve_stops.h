// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the curves of a reduced convolution meet, in order along each: crossings of two, and degenerate vertices, where
// ends touch other curves or each other or several curves cross. Guarantee: exact. Cost: that of the pairs in a grid of
// cells (broad_phase.h). Used by meeting_curves.cpp only.
#pragma once

#include <utility>
#include <vector>

#include "plane/base/arena.h"
#include "plane/grid/degenerate_vertices.h"
#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// Where another curve crosses a curve, or a degenerate vertex lies on it.
struct Stop {
  Index piece;  // kNone: one at the same place stands for it
  Index point;
  Index other;      // the other curve; kNone at a degenerate vertex
  bool from_right;  // the other curve passes from the right to the left
  Index twin;       // the place of this crossing among the stops of the other curve; at a degenerate vertex its number
};

struct CurveStops {
  CurveStops(std::size_t points, Memory memory)
      : stops(memory), first(memory), opposite(memory), degenerate_vertices(points, memory) {}

  std::pmr::vector<Stop> stops;                        // along every curve
  std::pmr::vector<Index> first;                       // of curve i: from first[i] to first[i + 1] - 1
  std::pmr::vector<std::pair<Index, Index>> opposite;  // curves that run along each other, the one to the right first
  DegenerateVertices degenerate_vertices;              // settled
};

/// Curves run with their inner side on the left: this one to the right?
inline bool runs_right(const ReducedConvolution& c, Index i) { return c.sides[i].left; }
inline Index start_of(const ReducedConvolution& c, Index i) {
  return runs_right(c, i) ? c.pieces[i].p0 : c.pieces[i].p1;
}
inline Index end_of(const ReducedConvolution& c, Index i) { return runs_right(c, i) ? c.pieces[i].p1 : c.pieces[i].p0; }

/// Adds the crossings to the geometry of `c`.
CurveStops find_stops(ReducedConvolution& c, Memory memory);

}  // namespace findspace::plane
