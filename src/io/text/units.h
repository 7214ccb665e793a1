// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The decimal grid on which a scene lives. Numbers come in as text, become exact reals, and are put on the grid once;
// every point that moved by that is counted, and how far. Nothing is clamped: a coordinate of
// more than 2^40 grid steps is refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "exact/number/real.h"
#include "formula/language/units.h"
#include "plane/contour/shape.h"

namespace findspace::io {

using formula::Unit;

/// `um mm cm m in mil`; throws Error(kUnknownName).
Unit parse_unit(std::string_view name);
/// Length of the decimal number at the start of `text`, 0 if there is none: [+-] digits [. digits] [e [+-] digits].
std::size_t scan_number(std::string_view text);
/// A number as messages show it, e.g. "12.5".
std::string show(double value);

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
  /// `step` > 0, in the scene's unit.
  explicit Grid(exact::Real step);

  const exact::Real& step() const { return step_; }
  /// One grid step in the scene's unit, rounded to a double (for messages and pictures).
  double step_size() const { return step_size_; }

  /// A length in the scene's unit, in grid steps; not rounded. |result| <= kLimit, else Error(kOutOfRange).
  exact::Real steps(const exact::Real& length) const;
  /// The nearest grid point to (x, y), in the scene's unit; ties away from zero. Error(kOutOfRange) beyond kLimit.
  plane::GridPoint nearest(const exact::Real& x, const exact::Real& y, RoundingLog& log) const;
  /// The nearest grid coordinate, and how far it is (in steps) from `length`.
  std::int64_t nearest(const exact::Real& length, double& moved) const;

 private:
  exact::Real step_;
  exact::Real per_unit_;  // 1 / step
  double step_size_ = 0;
};

}  // namespace findspace::io
