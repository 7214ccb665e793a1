// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The curves of a reduced convolution with the places where they meet: crossings of two, and degenerate_vertices, where
// ends touch other curves or each other or several curves cross. Guarantee: exact. Cost: that of the pairs in a grid of
// cells (broad_phase.h). Used by transversal_sum.cpp only.
#pragma once

#include <utility>
#include <vector>

#include "plane/base/arena.h"
#include "plane/grid/degenerate_vertices.h"
#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// Where another curve crosses a curve, or a degenerate lies on it.
struct Stop {
  Index piece;  // kNone: one at the same place stands for it
  Index point;
  Index other;      // the other curve; kNone at a degenerate
  bool from_right;  // the other curve passes from the right to the left
  Index twin;       // the place of this crossing among the stops of the other curve; at a degenerate its number
};

/// Of a curve, between two stops.
struct CurvePart {
  Index curve, slot;
};

class MeetingCurves {
 public:
  /// Finds where they meet.
  MeetingCurves(ReducedConvolution& c, Memory memory);

  Index size() const { return Index(c_.pieces.size()); }
  /// Curves run with their inner side on the left.
  bool right(Index i) const { return c_.sides[i].left; }
  Index start(Index i) const { return right(i) ? c_.pieces[i].p0 : c_.pieces[i].p1; }
  Index end(Index i) const { return right(i) ? c_.pieces[i].p1 : c_.pieces[i].p0; }
  Index supporting_curve(Index i) const { return c_.pieces[i].supporting_curve; }
  /// The curve that ends where curve i starts, or kNone.
  Index before(Index i) const { return ends_at_[start(i)]; }
  Index stop_count(Index i) const { return first_stop_[i + 1] - first_stop_[i]; }
  const Stop& stop(Index i, Index k) const { return stops_[first_stop_[i] + k]; }
  /// Parts of all curves between stops, counted through: part k of curve i ends at its stop k.
  Index part(CurvePart p) const { return first_stop_[p.curve] + p.curve + p.slot; }
  Index part_count() const { return Index(stops_.size()) + size(); }
  Index start(CurvePart p) const { return p.slot == 0 ? start(p.curve) : stop(p.curve, p.slot - 1).point; }
  Index end(CurvePart p) const { return p.slot == stop_count(p.curve) ? end(p.curve) : stop(p.curve, p.slot).point; }
  /// The degenerate at which a part starts, or kNone.
  Index knot_before(CurvePart p) const {
    if (p.slot == 0) return degenerate_vertices_.at(start(p.curve));
    const Stop& s = stop(p.curve, p.slot - 1);
    return s.other == kNone ? s.twin : kNone;
  }
  const DegenerateVertices& degenerate_vertices() const { return degenerate_vertices_; }

  /// Parts along which another curve runs the other way, so that both their sides are inner sides; some come twice.
  std::pmr::vector<CurvePart> parts_with_two_inner_sides() const;

 private:
  /// Notes where two curves meet.
  void cross(Index i, Index j);
  /// Two curves on one line.
  void overlap(Index i, Index j);
  /// An end of a curve on the line of curve i.
  void place(Index i, Index node);
  /// The end of a curve lies on curve i.
  void touch(Index i, Index node);

  /// Along every curve; what meets at one point becomes a degenerate, or is dropped if it is there twice.
  void sort_stops();
  void group_stops();
  void sort_stops_of(Index i);
  /// As nearly as approximate coordinates tell.
  void sort_by_estimate(Index i);
  void tie_stops_of(Index i);
  void drop_repeated();
  /// The two stops of a crossing find each other.
  void find_twins();

  /// Collects the directed_edges of the degenerate_vertices.
  void add_directed_edges();
  DirectedEdge directed_edge(Index degenerate, CurvePart part, bool starts, bool hides) const;

  ReducedConvolution& c_;
  exact::Geometry& g_;
  struct Estimate {
    double along;  // the curve
    Stop stop;
  };

  std::pmr::vector<Stop> stops_;
  std::pmr::vector<Estimate> estimates_;  // of one curve at a time
  std::pmr::vector<Index> first_stop_, ends_at_;
  std::pmr::vector<std::pair<Index, Index>> opposite_;  // curves that run along each other, the one to the right first
  DegenerateVertices degenerate_vertices_;
  Memory memory_;
};

}  // namespace findspace::plane
