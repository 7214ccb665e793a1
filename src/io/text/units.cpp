// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "findspace/error.h"

namespace findspace::io {
namespace {

using exact::Real;

std::size_t skip_digits(std::string_view text, std::size_t i) {
  while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
  return i;
}

}  // namespace

Unit parse_unit(std::string_view name) {
  if (auto unit = formula::find_unit(name)) return *unit;
  throw Error(ErrorCode::kUnknownName,
              fmt::format("unknown unit '{}'; the units are {}", name, fmt::join(formula::kUnitNames, ", ")));
}

std::size_t scan_number(std::string_view text) {
  std::size_t start = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  std::size_t i = skip_digits(text, start);
  std::size_t digits = i - start;
  if (i < text.size() && text[i] == '.') {
    std::size_t end = skip_digits(text, i + 1);
    digits += end - i - 1;
    i = end;
  }
  if (digits == 0) return 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t sign = i + 1 < text.size() && (text[i + 1] == '+' || text[i + 1] == '-') ? 1 : 0;
    std::size_t end = skip_digits(text, i + 1 + sign);
    if (end > i + 1 + sign) i = end;
  }
  return i;
}

std::string show(double value) { return fmt::format("{:.10g}", value == 0 ? 0.0 : value); }

void RoundingLog::add(double dx, double dy) {
  if (dx == 0 && dy == 0) return;
  ++points;
  largest = std::max(largest, std::hypot(dx, dy));
}

Grid::Grid(Real step) : step_(std::move(step)), per_unit_(Real(1) / step_), step_size_(step_.to_double()) {}

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

plane::GridPoint Grid::nearest(const Real& x, const Real& y, RoundingLog& log) const {
  double dx = 0, dy = 0;
  plane::GridPoint point{nearest(x, dx), nearest(y, dy)};
  log.add(dx, dy);
  return point;
}

}  // namespace findspace::io
