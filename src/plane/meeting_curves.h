// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The curves of a reduced convolution with the places where they meet: crossings of two, and knots, where ends touch
// other curves or each other. Guarantee: exact. Cost: that of the pairs in a grid of cells
// (broad_phase.h). Used by transversal_sum.cpp only.
#pragma once

#include <array>
#include <vector>

#include "plane/reduced_convolution.h"
#include "plane/scratch.h"

namespace findspace::plane {

/// Where another curve crosses a curve, or a knot lies on it.
struct Stop {
  Index piece, point;
  Index other;      // the other curve; kNone at a knot
  bool from_right;  // the other curve passes from the right to the left
  Index twin;       // the place of this crossing among the stops of the other curve; at a knot its index
};

/// A place where ends of curves touch other curves or each other.
struct Arm {
  Index knot, curve, slot;
  bool starts;  // part `slot` of the curve starts there, or ends there
};

constexpr Index kMostKnots = 64;

class MeetingCurves {
 public:
  MeetingCurves(ReducedConvolution& c, Memory memory)
      : c_(c),
        g_(c.geometry),
        stops_(memory),
        estimates_(memory),
        first_stop_(memory),
        ends_at_(memory),
        starts_at_(memory),
        knot_of_(memory),
        arms_(memory),
        memory_(memory) {}

  /// Finds all crossings; false if curves overlap with inner sides on both sides or three cross at a point.
  bool cross_all();

  Index size() const { return Index(c_.pieces.size()); }
  /// Curves run with their inner side on the left.
  bool right(Index i) const { return c_.sides[i].left; }
  Index start(Index i) const { return right(i) ? c_.pieces[i].p0 : c_.pieces[i].p1; }
  Index end(Index i) const { return right(i) ? c_.pieces[i].p1 : c_.pieces[i].p0; }
  Index carrier(Index i) const { return c_.pieces[i].carrier; }
  /// The curve that ends where curve i starts, or kNone.
  Index before(Index i) const { return ends_at_[start(i)]; }
  Index stop_count(Index i) const { return first_stop_[i + 1] - first_stop_[i]; }
  const Stop& stop(Index i, Index k) const { return stops_[first_stop_[i] + k]; }
  /// Parts of all curves between stops, counted through: part k of curve i ends at its stop k.
  Index part(Index i, Index k) const { return first_stop_[i] + i + k; }
  Index part_count() const { return Index(stops_.size()) + size(); }
  /// The knot at which part k of curve i starts, or kNone.
  Index knot_before(Index i, Index k) const {
    if (k > 0) return stop(i, k - 1).other == kNone ? stop(i, k - 1).twin : kNone;
    return knots_ > 0 ? knot_of_[start(i)] : kNone;
  }
  /// Could all directions at the knot lie on inner sides? Each curve covers less than half a turn; two cannot cover a
  /// whole one.
  bool could_hide_point(Index knot) const { return covers_[knot] >= 3; }
  Index knot_count() const { return knots_; }

  /// At a knot: of the arms, the first clockwise from the way of curve i that leaves it.
  const Arm& clockwise(Index knot, Index i, Index slot) const;

 private:
  bool meet_all();

  /// Notes where two curves meet; false if they overlap.
  bool cross(Index i, Index j);

  /// Two curves on one line; false if a whole piece has inner sides on both sides.
  bool overlap(Index i, Index j);

  /// An end of a curve on the line of curve i.
  bool place(Index i, Index node);

  /// An end of curves becomes a knot, or stays one.
  bool make_knot(Index node);
  bool touch(Index i, Index node);
  bool join(Index p, Index q);

  /// Along every curve; false if three curves meet at a point that is no knot.
  bool sort_stops();

  void sort_stops_of(Index i, Index first, Index last);
  /// As nearly as approximate coordinates tell.
  void sort_by_estimate(Index i, Index first, Index last);
  /// One crossing, or one knot.
  static bool same_place(const Stop& s, const Stop& t);

  /// The two stops of a crossing find each other.
  void find_twins();

  /// Collects the arms of the knots.
  void tie_knots();

  /// Is the arm p passed before q, turning clockwise from the way of curve i?
  bool comes_first(Index i, const Arm& p, const Arm& q) const;

  /// Clockwise from the way of curve i: 1 to the right, 2 straight back, 3 to the left, 4 the same way again.
  int half(Index i, const Arm& arm) const;

  /// Sign of the cross product of the directions in which two arms leave their knot.
  int cross_sign(const Arm& p, const Arm& q) const;

  ReducedConvolution& c_;
  exact::Geometry& g_;
  struct Estimate {
    double along;  // the curve
    Stop stop;
  };

  std::pmr::vector<Stop> stops_;
  std::pmr::vector<Estimate> estimates_;  // of one curve at a time
  std::pmr::vector<Index> first_stop_, ends_at_, starts_at_;
  std::pmr::vector<Index> knot_of_;  // point -> knot; empty while there is none
  Index knots_ = 0;
  std::pmr::vector<Arm> arms_;
  std::array<int, kMostKnots> covers_{};  // knot -> curves that hide directions there
  Memory memory_;
};

}  // namespace findspace::plane
