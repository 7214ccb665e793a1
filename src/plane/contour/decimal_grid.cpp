// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/contour/decimal_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "findspace/error.h"

namespace findspace::plane {

using exact::Real;

void RoundingLog::add(double dx, double dy) {
  if (dx == 0 && dy == 0) return;
  ++points;
  largest = std::max(largest, std::hypot(dx, dy));
}

Real decimal_of(double value) {
  if (!std::isfinite(value)) throw Error(ErrorCode::kBadValue, "a number must be finite");
  return Real::parse_decimal(fmt::format("{}", value));
}

Grid::Grid(Real step) : step_(std::move(step)), per_unit_(Real(1) / step_), step_size_(step_.to_double()) {
  steps_a_unit_ = per_unit_.to_double();
  const auto whole = per_unit_.integer();
  whole_ = whole && *whole <= kLimit;
}

Real Grid::steps(const Real& length) const {
  Real result = length * per_unit_;
  if (abs(result) > Real(kLimit)) {
    throw Error(ErrorCode::kOutOfRange,
                fmt::format("{} is more than 2^40 grid steps of {}; give the scene a coarser \"grid\"", length.text(),
                            step_.text()));
  }
  return result;
}

std::int64_t Grid::nearest(const Real& length, double& moved) const {
  Real value = steps(length);
  moved = 0;
  if (auto whole = value.integer()) return static_cast<std::int64_t>(*whole);
  exact::int128 rounded = round(value);  // ties away from zero
  moved = std::abs((value - Real(rounded)).to_double());
  return static_cast<std::int64_t>(rounded);
}

GridPoint Grid::nearest(const Real& x, const Real& y, RoundingLog& log) const {
  double dx = 0, dy = 0;
  GridPoint point{nearest(x, dx), nearest(y, dy)};
  log.add(dx, dy);
  return point;
}

Grid::Steps Grid::steps_near(double length) const {
  // Of so few digits no other decimal reads back as this double, so the decimal is the whole number of steps.
  constexpr double kFifteenDigits = 1e15;
  const double value = length * steps_a_unit_, whole = std::nearbyint(value);
  if (whole_ && std::abs(whole) < kFifteenDigits && whole / steps_a_unit_ == length) return {whole, 0};
  return {value, std::abs(value) * margin::kRoundings8};
}

std::int64_t Grid::nearest(double length, double& moved) const {
  const Steps s = steps_near(length);
  moved = 0;
  if (s.error == 0 && std::abs(s.value) <= double(kLimit)) return std::int64_t(s.value);
  const double rounded = std::nearbyint(s.value), off = std::abs(s.value - rounded);
  if (!(std::abs(s.value) < double(kLimit)) || off + s.error >= 0.5) return nearest(decimal_of(length), moved);
  moved = std::max(off, s.error);
  return std::int64_t(rounded);
}

GridPoint Grid::nearest(double x, double y, RoundingLog& log) const {
  double dx = 0, dy = 0;
  GridPoint point{nearest(x, dx), nearest(y, dy)};
  log.add(dx, dy);
  return point;
}

}  // namespace findspace::plane
