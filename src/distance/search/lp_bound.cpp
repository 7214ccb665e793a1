// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/lp_bound.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"

namespace findspace::distance {

namespace {

using Square = std::array<Column, 4>;  // by columns

double product(const Column& a, const Column& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

/// The inverse, by rows; false where a pivot vanishes.
bool invert(const Square& of, Square& out) {
  double m[4][8];
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      m[r][c] = of[c][r];
      m[r][4 + c] = r == c;
    }
  }
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t top = c;
    for (std::size_t r = c + 1; r < 4; ++r) {
      if (std::fabs(m[r][c]) > std::fabs(m[top][c])) top = r;
    }
    if (m[top][c] == 0) return false;
    std::swap(m[top], m[c]);
    const double pivot = 1 / m[c][c];
    for (double& x : m[c]) x *= pivot;
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == c) continue;
      const double factor = m[r][c];
      for (std::size_t k = c; k < 8; ++k) m[r][k] -= factor * m[c][k];
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t c = 0; c < 4; ++c) out[r][c] = m[r][4 + c];
  }
  return true;
}

/// max sum x, A x <= 1, x >= 0, where A's columns are those of the linear program over the greatest entry, and 1 more.
/// What the weights of a basis are worth in it is kept where it is the best so far: so columns that are
/// nearly the same, whose bases are made of rounding, do no harm. The last basis is inverted anew, and steps go on from
/// there.
class Simplex {
 public:
  Simplex(const std::vector<Column>& columns, double shift) : columns_(columns), shift_(shift) {
    for (std::size_t r = 0; r < 4; ++r) basis_[r] = columns.size() + r;
    best_.value = exact::kInfinity;
  }

  LpBound run() {
    constexpr int kMostSteps = 100;
    for (std::size_t k = 0; k < 4; ++k) inverse_[k][k] = 1;
    bool anew = true;
    for (int step = 0; step < kMostSteps; ++step) {
      const std::size_t in = price();
      if (best_.value - lowest_ <= margin::kLpClose * shift_) break;
      if (in != none()) {
        if (!enter(in)) break;
        anew = false;
        continue;
      }
      if (anew) break;
      Square basis;
      for (std::size_t r = 0; r < 4; ++r) basis[r] = column(basis_[r]);
      if (!invert(basis, inverse_)) break;
      anew = true;
    }
    return best_;
  }

 private:
  std::size_t none() const { return columns_.size() + 4; }
  Column column(std::size_t j) const {
    Column out{};
    if (j >= columns_.size()) {
      out[j - columns_.size()] = 1;
      return out;
    }
    for (std::size_t r = 0; r < 4; ++r) out[r] = columns_[j][r] / shift_ + 1;
    return out;
  }

  /// The column that helps most; and what both players' weights are worth.
  std::size_t price() {
    Column rows{}, mean{};
    double weights = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      x_[k] = inverse_[k][0] + inverse_[k][1] + inverse_[k][2] + inverse_[k][3];
      if (basis_[k] >= columns_.size()) continue;
      for (std::size_t r = 0; r < 4; ++r) rows[r] += inverse_[k][r];
      const double w = std::max(0.0, x_[k]);
      weights += w;
      for (std::size_t r = 0; r < 4; ++r) mean[r] += w * columns_[basis_[k]][r];
    }
    if (weights > 0) best_.value = std::min(best_.value, *std::max_element(mean.begin(), mean.end()) / weights);
    std::size_t in = none();
    double most = margin::kLpHelps;
    const auto take = [&](std::size_t j, double gain) {
      if (gain > most && std::find(basis_.begin(), basis_.end(), j) == basis_.end()) {
        most = gain;
        in = j;
      }
    };
    for (std::size_t r = 0; r < 4; ++r) take(columns_.size() + r, -rows[r]);
    Column mix;
    double sum = 0, least = exact::kInfinity;
    for (std::size_t r = 0; r < 4; ++r) sum += mix[r] = std::max(0.0, rows[r]);
    const double all = rows[0] + rows[1] + rows[2] + rows[3];
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      take(j, 1 - product(rows, columns_[j]) / shift_ - all);
      least = std::min(least, product(mix, columns_[j]));
    }
    if (sum > 0 && least / sum > lowest_) {
      lowest_ = least / sum;
      for (std::size_t r = 0; r < 4; ++r) best_.rows[r] = mix[r] / sum;
    }
    return in;
  }

  bool enter(std::size_t in) {
    const Column added = column(in);
    Column by;
    std::size_t out = 4;
    for (std::size_t k = 0; k < 4; ++k) {
      by[k] = product(inverse_[k], added);
      if (by[k] > margin::kLpPivot && (out == 4 || x_[k] * by[out] < x_[out] * by[k])) out = k;
    }
    if (out == 4) return false;
    basis_[out] = in;
    const double pivot = 1 / by[out];
    for (double& entry : inverse_[out]) entry *= pivot;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == out) continue;
      for (std::size_t r = 0; r < 4; ++r) inverse_[k][r] -= by[k] * inverse_[out][r];
    }
    return true;
  }

  const std::vector<Column>& columns_;
  double shift_;
  std::array<std::size_t, 4> basis_;
  Square inverse_{};
  Column x_{};
  LpBound best_;
  double lowest_ = -1;
};

}  // namespace

LpBound lp_bound(const std::vector<Column>& columns) {
  double shift = 0;
  for (const Column& c : columns) shift = std::max(shift, *std::max_element(c.begin(), c.end()));
  if (shift == 0) return {0, {1, 0, 0, 0}};
  return Simplex(columns, shift).run();
}

LpBound bounding_lp(std::vector<Column> columns, const std::optional<Column>& beyond) {
  if (beyond) {
    const std::size_t count = columns.size();
    for (std::size_t k = 0; k < count; ++k) {
      Column less = columns[k];
      for (std::size_t v = 0; v < 4; ++v) less[v] -= (*beyond)[v];
      columns.push_back(less);
    }
  }
  double least = 0;
  for (const auto& c : columns) least = std::min(least, *std::min_element(c.begin(), c.end()));
  if (least < 0) {
    for (auto& c : columns) {
      for (double& entry : c) entry -= least;
    }
  }
  LpBound bound = lp_bound(columns);
  bound.value += least;
  return bound;
}

}  // namespace findspace::distance
