// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Positions p_0 = O, p_1 .. p_n whose differences lie in boxes: on every axis a system of difference constraints
// p_i - p_j <= c or < c, kept closed under paths, so that each difference has its tightest bounds. Guarantee: exact;
// bounds say whether they are taken, `empty` whether no positions are left. Cost: n^2 comparisons for a constraint.
// Source: shortest paths, Cormen et al., Introduction to Algorithms, section 24.4. Keywords: difference constraints,
// shortest path closure.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "space/box/box_complex.h"

namespace findspace::planning {

class DifferenceBoxes {
 public:
  explicit DifferenceBoxes(std::size_t positions);

  /// p_i - p_j lies in the box.
  void demand(std::size_t i, std::size_t j, const space::IntervalBox& box);
  bool empty() const { return empty_; }
  /// All values of p_i - p_j.
  space::IntervalBox range(std::size_t i, std::size_t j) const;

 private:
  struct Bound {
    std::optional<exact::Real> most;  // none: none
    bool in = true;
  };
  static bool is_tighter(const Bound& a, const Bound& b);
  static Bound joined(const Bound& a, const Bound& b);
  Bound& at(std::size_t axis, std::size_t i, std::size_t j) { return bounds_[(axis * size_ + i) * size_ + j]; }
  const Bound& at(std::size_t axis, std::size_t i, std::size_t j) const {
    return bounds_[(axis * size_ + i) * size_ + j];
  }
  void limit(std::size_t axis, std::size_t i, std::size_t j, const Bound& bound);

  std::size_t size_;
  std::vector<Bound> bounds_;  // of p_i - p_j
  bool empty_ = false;
};

}  // namespace findspace::planning
