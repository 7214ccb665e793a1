// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The decimal grid on which shapes live. Numbers come in as exact reals or as doubles and are put on the grid once;
// every point that moved by that is counted, and how far. A double stands for the shortest decimal that reads back as
// it. Nothing is clamped: a coordinate of more than 2^40 grid steps is refused. Keywords: fixed point, quantisation,
// snap rounding (not used).
#pragma once

#include <cstdint>

#include "exact/number/real.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// What putting points on the grid has done so far.
struct RoundingLog {
  std::int64_t points = 0;  // how many moved
  double largest = 0;       // the largest move, in grid steps
  void add(double dx, double dy);
};

class Grid {
 public:
  static constexpr std::int64_t kLimit = std::int64_t{1} << 40;

  Grid() : Grid(exact::Real::ratio(1, 1000000)) {}
  /// `step` > 0, in the unit of the shapes.
  explicit Grid(exact::Real step);

  const exact::Real& step() const { return step_; }
  /// One grid step in the unit, rounded to a double (for messages and pictures).
  double step_size() const { return step_size_; }

  /// A length in the unit, in grid steps; not rounded. |result| <= kLimit, else Error(kOutOfRange).
  exact::Real steps(const exact::Real& length) const;
  /// The nearest grid point to (x, y), in the unit; ties away from zero. Error(kOutOfRange) beyond kLimit.
  GridPoint nearest(const exact::Real& x, const exact::Real& y, RoundingLog& log) const;
  /// The nearest grid coordinate, and how far it is (in steps) from `length`.
  std::int64_t nearest(const exact::Real& length, double& moved) const;
  /// The same of a double. Error(kBadValue) where it is not finite. Cost: a few nanoseconds.
  std::int64_t nearest(double length, double& moved) const;
  GridPoint nearest(double x, double y, RoundingLog& log) const;

  /// A double in grid steps, off by at most `error`; the exact number of steps where that is whole and `error` 0.
  struct Steps {
    double value, error;
  };
  Steps steps_near(double length) const;
  /// The number of steps of a double that is on the grid; false where that is not seen at once.
  bool whole_steps(double length, std::int64_t& steps) const {
    constexpr double kMost = 1e12;  // below kLimit, and of so few digits no other decimal reads back as the double
    const double value = length * steps_a_unit_;
    if (!whole_ || !(value < kMost && value > -kMost)) return false;
    steps = static_cast<std::int64_t>(value + (value < 0 ? -0.5 : 0.5));
    return static_cast<double>(steps) / steps_a_unit_ == length;
  }

 private:
  exact::Real step_;
  exact::Real per_unit_;  // 1 / step
  double step_size_ = 0, steps_a_unit_ = 0;
  bool whole_ = false;  // so is the number of steps a unit, and exact as a double
};

/// The decimal that a double stands for: the shortest that reads back as it. Error(kBadValue) where it is not finite.
exact::Real decimal_of(double value);

}  // namespace findspace::plane
