// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A small linear program to which rows are added one after another, as a branch and bound does: the least value of the
// last column over the rows a . x >= b. A vertex that is optimal for some of the rows is kept; a row that it violates
// takes the place of another (dual simplex). Guarantee: the vertex is that of doubles, and what it says of the least
// value is proved by interval arithmetic from its multipliers: a value below which no x within the bounds of the
// columns satisfies the rows. Whatever the rounding, that bound is right; only how high it is depends on it. Cost: the
// square of the columns for a row that is exchanged. Source: Neumaier, Shcherbina, "Safe bounds in linear and
// mixed-integer linear programming" (2004). Keywords: dual simplex, safe bound, Farkas certificate.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "exact/number/interval.h"

namespace findspace::packing {

/// The sum of its terms is at least `right`.
struct CertainRow {
  static constexpr std::size_t kMost = 6;
  std::size_t terms = 0;
  std::array<std::size_t, kMost> column = {};
  std::array<exact::Interval, kMost> factor = {};
  std::array<double, kMost> middle = {};  // of the factors
  exact::Interval right;
  double right_middle = 0;

  void add(std::size_t at, const exact::Interval& by);
  void set_right(const exact::Interval& least);
  /// What the sum lacks at a vertex, in doubles; below 0 where it is more.
  double lack(const std::vector<double>& vertex) const;
};

/// The rows that may be asked for, and the bounds of the columns: rows 2 k and 2 k + 1 are those of column k.
class CertainRows {
 public:
  /// Vertices are sought to a billionth of `size`.
  CertainRows(std::vector<exact::Interval> bounds, double size);

  double size() const { return size_; }
  std::size_t columns() const { return bounds_.size(); }
  const std::vector<exact::Interval>& bounds() const { return bounds_; }
  std::size_t add(const CertainRow& row);
  const CertainRow& operator[](std::size_t row) const { return rows_[row]; }
  std::size_t count() const { return rows_.size(); }

 private:
  std::vector<exact::Interval> bounds_;
  double size_;
  std::vector<CertainRow> rows_;
};

class GrowingProgram {
 public:
  /// With the bounds of the columns alone. The rows must live as long.
  explicit GrowingProgram(const CertainRows& rows);

  void add(std::size_t row) { active_.push_back(row); }
  /// Goes on to the optimal vertex, or until the least value is proved to be `enough` or no x is left: then false.
  bool solve(double enough);

  const std::vector<double>& vertex() const { return vertex_; }
  /// Proved. Infinite where no x is left.
  double bound() const { return bound_; }

 private:
  /// The most violated of the active rows; none: size of the rows.
  std::size_t most_violated() const;
  /// The row as a sum of those of the basis.
  void decompose(const CertainRow& row);
  std::size_t leaving() const;
  void exchange(std::size_t slot, std::size_t row);
  double proved_value() const;
  bool is_proved_empty(std::size_t row) const;
  exact::Interval least_of(std::span<const std::pair<std::size_t, double>> multipliers, bool with_goal) const;

  const CertainRows* rows_;
  std::vector<std::size_t> active_, basis_;
  std::vector<double> inverse_;  // of the basis: vertex = inverse x right sides
  std::vector<double> vertex_, multipliers_, shaken_, parts_;
  double bound_;
};

}  // namespace findspace::packing
