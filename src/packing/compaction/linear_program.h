// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A linear program that is stated row by row: least cost over columns within bounds, rows at least a number.
// Lengths are divided by a unit, so that tolerances are relative to it. Guarantee: that of the solver, CLP.
// Cost: dual simplex. Keywords: linear programming, simplex method.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace findspace::packing {

class LinearProgram {
 public:
  explicit LinearProgram(double unit);
  ~LinearProgram();
  LinearProgram(const LinearProgram&) = delete;
  LinearProgram& operator=(const LinearProgram&) = delete;

  /// The number of the column.
  int add_column(double low, double high, double cost);
  void begin_row(double least);
  /// To the last row.
  void add(int column, double factor);
  /// False where there is no solution.
  bool solve();
  double value(int column) const { return solution_[std::size_t(column)] * unit_; }

 private:
  double unit_;
  std::vector<double> low_, high_, cost_, least_, factors_, solution_;
  std::vector<int> columns_, starts_;
};

}  // namespace findspace::packing
