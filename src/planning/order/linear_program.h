// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Linear programs of few variables in exact reals: rows a.x <= b, variables free. Feasible or not, and a greatest value
// with a point that has it, without any rounding. Method: a dictionary; free variables are solved for first,
// feasibility by the dual simplex for the objective 0, then the primal simplex; Bland's rule in both, so no cycling.
// Cost: rows times variables a pivot, a pivot or two a row. Source: Chvatal, "Linear Programming", chapters 2, 3
// and 10. Keywords: simplex, exact linear programming, feasibility.
#pragma once

#include <optional>
#include <vector>

#include "exact/number/real.h"

namespace findspace::planning {

class LinearProgram {
 public:
  explicit LinearProgram(std::size_t variables) : variables_(variables) {}

  /// row.x <= bound. All rows are added before the first question.
  void add(std::vector<exact::Real> row, exact::Real bound);

  /// Whether some point satisfies all rows. A variable no row holds may be anything; it is 0 in solutions.
  bool feasible();
  /// A point with the greatest objective.x; nothing where there is no greatest. Needs feasible().
  std::optional<std::vector<exact::Real>> maximise(const std::vector<exact::Real>& objective);

 private:
  struct Row {
    std::vector<exact::Real> terms;  // basic variable = value - sum of terms[j] * nonbasic j
    exact::Real value;
  };
  bool is_free(std::size_t variable) const { return variable < variables_; }
  void solve_for_free_variables();
  void pivot(std::size_t row, std::size_t column);
  bool restore();

  std::size_t variables_;
  std::vector<Row> rows_;
  std::vector<std::size_t> basic_, nonbasic_;  // variables: first the free ones, then the slack of each row
  std::optional<bool> feasible_;
};

}  // namespace findspace::planning
