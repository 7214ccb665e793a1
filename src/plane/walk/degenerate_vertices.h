// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The places where directed curves do more than continue or cross in pairs, and the ways that leave them: which way
// comes next in clockwise order, and whether the inner sides of the curves go all round the place. Guarantee: exact.
// Cost: the pairs of half-edges at a degenerate vertex. Used by meeting_curves.cpp and transversal_sum.cpp only.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "plane/base/arena.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// A way of a curve that leaves a degenerate vertex.
struct DirectedEdge {
  Index degenerate, curve, slot;
  bool starts;          // part `slot` of the curve starts there, or ends there
  bool hides;           // the curve's inner side hides directions at the degenerate vertex
  std::int64_t dx, dy;  // away from the degenerate vertex
  Index next = kNone;   // another half-edge of the degenerate vertex
};

class DegenerateVertices {
 public:
  /// `points`: about how many there will be.
  DegenerateVertices(std::size_t points, Memory memory)
      : points_(points), degenerate_of_(memory), same_(memory), directed_edges_(memory), first_directed_edge_(memory) {}

  bool empty() const { return same_.empty(); }
  /// A point becomes a degenerate vertex, or stays one.
  void make(Index point);
  /// Two points are the same place.
  void tie(Index p, Index q);
  /// Numbers the degenerate vertices; no more are made. `points`: how many there are.
  void settle(std::size_t points);

  Index count() const { return count_; }
  /// The degenerate vertex at a point, or kNone.
  Index at(Index point) const { return empty() ? kNone : degenerate_of_[point]; }
  /// One of its points.
  Index point(Index degenerate) const {
    return Index(std::find(degenerate_of_.begin(), degenerate_of_.end(), degenerate) - degenerate_of_.begin());
  }

  /// After settling; `directed_edges`: about how many there will be.
  void reserve(std::size_t directed_edges);
  void add(DirectedEdge directed_edge) {
    directed_edge.next = std::exchange(first_directed_edge_[directed_edge.degenerate], Index(directed_edges_.size()));
    directed_edges_.push_back(directed_edge);
  }

  /// Of the other half-edges, the first clockwise from the one of a part that starts at the degenerate vertex.
  const DirectedEdge& clockwise(Index degenerate, Index curve, Index slot) const;
  /// Do inner sides of curves hide all directions? Only then can the degenerate vertex be a single point outside the
  /// open sum.
  bool is_surrounded(Index degenerate) const;

 private:
  const DirectedEdge* first(Index degenerate) const { return &directed_edges_[first_directed_edge_[degenerate]]; }
  const DirectedEdge* next(const DirectedEdge& directed_edge) const {
    return directed_edge.next == kNone ? nullptr : &directed_edges_[directed_edge.next];
  }
  Index& parent(Index point);

  std::size_t points_;
  ArenaVector<Index> degenerate_of_;  // point -> degenerate vertex; empty while there is none
  ArenaVector<Index> same_;           // degenerate vertex -> one with a smaller number at the same place, or itself
  ArenaVector<DirectedEdge> directed_edges_;
  ArenaVector<Index> first_directed_edge_;  // degenerate vertex -> the last one added
  Index count_ = 0;
};

}  // namespace findspace::plane
