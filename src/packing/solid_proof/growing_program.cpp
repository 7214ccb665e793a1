// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/growing_program.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

using exact::enclose;
using exact::Interval;

constexpr std::size_t kMostExchanges = 400;  // of one solve; the bound is right after any number
constexpr double kGolden = 0.6180339887498949;

double middle_of(const Interval& a) { return 0.5 * (a.lo + a.hi); }
Interval point(double x) { return {x, x}; }

}  // namespace

void CertainRow::add(std::size_t at, const Interval& by) {
  if (by.lo == 0 && by.hi == 0) return;
  column[terms] = at;
  factor[terms] = by;
  middle[terms++] = middle_of(by);
}

void CertainRow::set_right(const Interval& least) {
  right = least;
  right_middle = middle_of(least);
}

double CertainRow::lack(const std::vector<double>& vertex) const {
  double result = right_middle;
  for (std::size_t t = 0; t < terms; ++t) result -= middle[t] * vertex[column[t]];
  return result;
}

CertainRows::CertainRows(std::vector<Interval> bounds, double size) : bounds_(std::move(bounds)), size_(size) {
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    CertainRow low, high;
    low.add(k, point(1));
    low.set_right(point(bounds_[k].lo));
    high.add(k, point(-1));
    high.set_right(point(-bounds_[k].hi));
    rows_.push_back(low);
    rows_.push_back(high);
  }
}

std::size_t CertainRows::add(const CertainRow& row) {
  rows_.push_back(row);
  return rows_.size() - 1;
}

GrowingProgram::GrowingProgram(const CertainRows& rows) : rows_(&rows), bound_(-exact::kInfinity) {
  const std::size_t n = rows.columns();
  inverse_.resize(n * n);
  vertex_.resize(n);
  multipliers_.resize(n);
  shaken_.resize(n);
  parts_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    basis_.push_back(2 * k);
    active_.push_back(2 * k + 1);
    inverse_[k * n + k] = 1;
    vertex_[k] = rows.bounds()[k].lo;
    // Different for all columns, so that no two exchanges are equally good.
    shaken_[k] = margin::kHeightShake * (1 + std::fmod(kGolden * double(k + 1), 1.0));
  }
  multipliers_[n - 1] = 1;
  shaken_[n - 1] += 1;
}

std::size_t GrowingProgram::most_violated() const {
  std::size_t result = rows_->count();
  double most = margin::kHeightRow * rows_->size();
  for (const std::size_t row : active_)
    if (const double by = (*rows_)[row].lack(vertex_); by > most) {
      most = by;
      result = row;
    }
  return result;
}

void GrowingProgram::decompose(const CertainRow& row) {
  const std::size_t n = basis_.size();
  std::fill(parts_.begin(), parts_.end(), 0.0);
  for (std::size_t t = 0; t < row.terms; ++t) {
    const double by = row.middle[t];
    const double* line = &inverse_[row.column[t] * n];
    for (std::size_t k = 0; k < n; ++k) parts_[k] += by * line[k];
  }
}

/// The slot whose multiplier comes to 0 first; none: the number of columns.
std::size_t GrowingProgram::leaving() const {
  std::size_t result = basis_.size();
  double least = exact::kInfinity;
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    if (parts_[k] <= margin::kHeightPivot) continue;
    if (const double ratio = shaken_[k] / parts_[k]; ratio < least) {
      least = ratio;
      result = k;
    }
  }
  return result;
}

void GrowingProgram::exchange(std::size_t slot, std::size_t row) {
  const std::size_t n = basis_.size();
  const double by = (*rows_)[row].lack(vertex_), part = parts_[slot];
  const double shaken = shaken_[slot] / part, multiplier = multipliers_[slot] / part;
  for (std::size_t k = 0; k < n; ++k) {
    shaken_[k] -= shaken * parts_[k];
    multipliers_[k] -= multiplier * parts_[k];
  }
  shaken_[slot] = shaken;
  multipliers_[slot] = multiplier;
  for (std::size_t j = 0; j < n; ++j) {
    double* line = &inverse_[j * n];
    const double mine = line[slot] / part;
    if (mine != 0)
      for (std::size_t k = 0; k < n; ++k) line[k] -= parts_[k] * mine;
    line[slot] = mine;
    vertex_[j] += by * mine;
  }
  active_.push_back(basis_[slot]);
  basis_[slot] = row;
  active_.erase(std::find(active_.begin(), active_.end(), row));
}

/// What the rows times their multipliers, none below 0, say of the goal, or of 0 without it.
Interval GrowingProgram::least_of(std::span<const std::pair<std::size_t, double>> multipliers, bool with_goal) const {
  std::vector<Interval> left(basis_.size(), point(0));
  if (with_goal) left.back() = point(1);
  Interval sum = point(0);
  for (const auto& [index, by] : multipliers) {
    const CertainRow& row = (*rows_)[index];
    sum = sum + point(by) * row.right;
    for (std::size_t t = 0; t < row.terms; ++t) left[row.column[t]] = left[row.column[t]] - point(by) * row.factor[t];
  }
  for (std::size_t k = 0; k < left.size(); ++k) {
    const Interval product = left[k] * rows_->bounds()[k];
    sum = sum + point(product.lo);
  }
  return sum;
}

double GrowingProgram::proved_value() const {
  std::vector<std::pair<std::size_t, double>> used;
  for (std::size_t k = 0; k < basis_.size(); ++k)
    if (multipliers_[k] > 0) used.emplace_back(basis_[k], multipliers_[k]);
  return least_of(used, true).lo;
}

/// The row is at most 0 times the rows of the basis, and yet more is asked of it.
bool GrowingProgram::is_proved_empty(std::size_t row) const {
  std::vector<std::pair<std::size_t, double>> used{{row, 1.0}};
  for (std::size_t k = 0; k < basis_.size(); ++k)
    if (parts_[k] < 0) used.emplace_back(basis_[k], -parts_[k]);
  return least_of(used, false).lo > 0;
}

bool GrowingProgram::solve(double enough) {
  for (std::size_t k = 0; k < kMostExchanges; ++k) {
    if (vertex_.back() >= enough) {
      bound_ = std::max(bound_, proved_value());
      if (bound_ >= enough) return false;
    }
    const std::size_t row = most_violated();
    if (row == rows_->count()) break;
    decompose((*rows_)[row]);
    const std::size_t slot = leaving();
    if (slot == basis_.size()) {
      if (is_proved_empty(row)) {
        bound_ = exact::kInfinity;
        return false;
      }
      break;
    }
    exchange(slot, row);
  }
  bound_ = std::max(bound_, proved_value());
  return bound_ < enough;
}

}  // namespace findspace::packing
