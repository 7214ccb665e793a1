// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/order/linear_program.h"

#include <utility>

namespace findspace::planning {

using exact::Real;

void LinearProgram::add(std::vector<Real> row, Real bound) { rows_.push_back({std::move(row), std::move(bound)}); }

bool LinearProgram::feasible() {
  if (feasible_) return *feasible_;
  for (std::size_t j = 0; j < variables_; ++j) nonbasic_.push_back(j);
  for (std::size_t i = 0; i < rows_.size(); ++i) basic_.push_back(variables_ + i);
  solve_for_free_variables();
  feasible_ = restore();
  return *feasible_;
}

void LinearProgram::solve_for_free_variables() {
  for (std::size_t j = 0; j < variables_; ++j) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (is_free(basic_[i]) || rows_[i].terms[j].sign() == 0) continue;
      pivot(i, j);
      break;
    }
  }
}

/// basic_[row] and nonbasic_[column] change places.
void LinearProgram::pivot(std::size_t row, std::size_t column) {
  Row& r = rows_[row];
  const Real factor = Real(1) / r.terms[column];
  for (std::size_t j = 0; j < r.terms.size(); ++j) r.terms[j] = j == column ? factor : r.terms[j] * factor;
  r.value = r.value * factor;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (i == row || rows_[i].terms[column].sign() == 0) continue;
    Row& other = rows_[i];
    const Real by = other.terms[column];
    for (std::size_t j = 0; j < r.terms.size(); ++j) {
      if (j == column)
        other.terms[j] = -by * factor;
      else if (r.terms[j].sign() != 0)
        other.terms[j] = other.terms[j] - by * r.terms[j];
    }
    other.value = other.value - by * r.value;
  }
  std::swap(basic_[row], nonbasic_[column]);
}

/// The dual simplex: rows with a negative value leave. Free variables that are still nonbasic occur in no row.
bool LinearProgram::restore() {
  while (true) {
    std::size_t leaving = rows_.size();
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!is_free(basic_[i]) && rows_[i].value.sign() < 0 && (leaving == rows_.size() || basic_[i] < basic_[leaving]))
        leaving = i;
    if (leaving == rows_.size()) return true;
    std::size_t entering = variables_;
    for (std::size_t j = 0; j < variables_; ++j)
      if (rows_[leaving].terms[j].sign() < 0 && (entering == variables_ || nonbasic_[j] < nonbasic_[entering]))
        entering = j;
    if (entering == variables_) return false;
    pivot(leaving, entering);
  }
}

std::optional<std::vector<Real>> LinearProgram::maximise(const std::vector<Real>& objective) {
  // The objective in the nonbasic variables: gain of one unit of each.
  std::vector<Real> gain(variables_);
  while (true) {
    for (std::size_t j = 0; j < variables_; ++j) {
      Real g = is_free(nonbasic_[j]) ? objective[nonbasic_[j]] : Real(0);
      for (std::size_t i = 0; i < rows_.size(); ++i)
        if (is_free(basic_[i]) && objective[basic_[i]].sign() != 0) g = g - objective[basic_[i]] * rows_[i].terms[j];
      gain[j] = g;
    }
    std::size_t entering = variables_;
    for (std::size_t j = 0; j < variables_; ++j) {
      if (is_free(nonbasic_[j]) && gain[j].sign() != 0) return std::nullopt;  // no row holds it
      if (gain[j].sign() > 0 && (entering == variables_ || nonbasic_[j] < nonbasic_[entering])) entering = j;
    }
    if (entering == variables_) break;
    std::size_t leaving = rows_.size();
    Real least;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (is_free(basic_[i]) || rows_[i].terms[entering].sign() <= 0) continue;
      const Real ratio = rows_[i].value / rows_[i].terms[entering];
      const int order = leaving == rows_.size() ? -1 : compare(ratio, least);
      if (order < 0 || (order == 0 && basic_[i] < basic_[leaving])) {
        leaving = i;
        least = ratio;
      }
    }
    if (leaving == rows_.size()) return std::nullopt;
    pivot(leaving, entering);
  }
  std::vector<Real> at(variables_);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (is_free(basic_[i])) at[basic_[i]] = rows_[i].value;
  return at;
}

}  // namespace findspace::planning
