// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The places where directed curves do more than continue or cross in pairs, and the ways that leave them: which way
// comes next in clockwise order, and whether the inner sides of the curves go all round the place. Guarantee: exact.
// Cost: the pairs of arms at a knot. Used by meeting_curves.cpp and transversal_sum.cpp only.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "plane/base/scratch.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// A way of a curve that leaves a knot.
struct Arm {
  Index knot, curve, slot;
  bool starts;          // part `slot` of the curve starts there, or ends there
  bool hides;           // the curve's inner side hides directions at the knot
  std::int64_t dx, dy;  // away from the knot
  Index next = kNone;   // another arm of the knot
};

class Knots {
 public:
  /// `points`: about how many there will be.
  Knots(std::size_t points, Memory memory)
      : points_(points), knot_of_(memory), same_(memory), arms_(memory), first_arm_(memory) {}

  bool empty() const { return same_.empty(); }
  /// A point becomes a knot, or stays one.
  void make(Index point);
  /// Two points are the same place.
  void tie(Index p, Index q);
  /// Numbers the knots; no more are made. `points`: how many there are.
  void settle(std::size_t points);

  Index count() const { return count_; }
  /// The knot at a point, or kNone.
  Index at(Index point) const { return empty() ? kNone : knot_of_[point]; }
  /// One of its points.
  Index point(Index knot) const { return Index(std::find(knot_of_.begin(), knot_of_.end(), knot) - knot_of_.begin()); }

  /// After settling; `arms`: about how many there will be.
  void reserve(std::size_t arms);
  void add(Arm arm) {
    arm.next = std::exchange(first_arm_[arm.knot], Index(arms_.size()));
    arms_.push_back(arm);
  }

  /// Of the other arms, the first clockwise from the one of a part that starts at the knot.
  const Arm& clockwise(Index knot, Index curve, Index slot) const;
  /// Do inner sides of curves hide all directions? Only then can the knot be a single point outside the open sum.
  bool is_surrounded(Index knot) const;

 private:
  const Arm* first(Index knot) const { return &arms_[first_arm_[knot]]; }
  const Arm* next(const Arm& arm) const { return arm.next == kNone ? nullptr : &arms_[arm.next]; }
  Index& parent(Index point);

  std::size_t points_;
  std::pmr::vector<Index> knot_of_;  // point -> knot; empty while there is none
  std::pmr::vector<Index> same_;     // knot -> one with a smaller number at the same place, or itself
  std::pmr::vector<Arm> arms_;
  std::pmr::vector<Index> first_arm_;  // knot -> the last one added
  Index count_ = 0;
};

}  // namespace findspace::plane
