// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/inner_mask.h"

#include <algorithm>
#include <cmath>

namespace findspace::plane {
namespace {

/// Cells [first, last] of a row, all inside the set.
struct Run {
  std::int64_t row, first, last;
};

/// Half a cell more than enough for the rounding of the arithmetic here: coordinates stay below 2^43 steps, sides
/// above 2.
constexpr double kSlack = 0x1p-6;

class Raster {
 public:
  Raster(const Outline& outline, double side) : side_(side) {
    for (const LatticeEdge& e : outline) {
      low_ = std::min({low_, e.y0, e.y1});
      high_ = std::max({high_, e.y0, e.y1});
    }
    first_row_ = std::int64_t(std::floor(low_ / side_));
    std::size_t rows = std::size_t(std::int64_t(std::floor(high_ / side_)) - first_row_ + 1);
    crossings_.resize(rows);
    touched_.resize(rows);
    for (const LatticeEdge& e : outline) enter(e);
  }

  std::vector<Run> runs() {
    std::vector<Run> out;
    for (std::size_t r = 0; r < crossings_.size(); ++r) add_row(r, out);
    return out;
  }

 private:
  struct Columns {
    std::int64_t first, last;
  };

  void enter(const LatticeEdge& e) {
    double y0 = std::min(e.y0, e.y1), y1 = std::max(e.y0, e.y1);
    auto x_at = [&](double y) { return e.y0 == e.y1 ? e.x0 : e.x0 + (e.x1 - e.x0) * ((y - e.y0) / (e.y1 - e.y0)); };
    std::int64_t last = std::min(row(y1 / side_ + kSlack), std::int64_t(crossings_.size()) - 1);
    for (std::int64_t r = std::max<std::int64_t>(row(y0 / side_ - kSlack), 0); r <= last; ++r) {
      double bottom = double(first_row_ + r) * side_, low = std::max(y0, bottom), high = std::min(y1, bottom + side_);
      double xa = x_at(std::min(low, y1)), xb = x_at(std::max(high, y0));
      if (y0 == y1) xa = e.x0, xb = e.x1;
      touched_[std::size_t(r)].push_back(
          {column(std::min(xa, xb) / side_ - kSlack), column(std::max(xa, xb) / side_ + kSlack)});
      double middle = bottom + side_ / 2;
      if (y0 <= middle && middle < y1) crossings_[std::size_t(r)].push_back(x_at(middle));
    }
  }

  void add_row(std::size_t r, std::vector<Run>& out) {
    auto& x = crossings_[r];
    auto& touched = touched_[r];
    std::sort(x.begin(), x.end());
    std::sort(touched.begin(), touched.end(), [](const Columns& p, const Columns& q) { return p.first < q.first; });
    std::size_t t = 0;
    std::int64_t at = INT64_MIN;  // everything to the left is passed or touched
    for (std::size_t k = 0; k + 1 < x.size(); k += 2) {
      std::int64_t end = column(x[k + 1] / side_);
      at = std::max(at, column(x[k] / side_));
      // Between the crossings, the cells no edge touches.
      for (; t < touched.size() && touched[t].first <= end; ++t) {
        if (touched[t].first > at) out.push_back({first_row_ + std::int64_t(r), at, touched[t].first - 1});
        at = std::max(at, touched[t].last + 1);
      }
      if (at <= end) out.push_back({first_row_ + std::int64_t(r), at, end});
    }
  }

  std::int64_t row(double lines) const { return std::int64_t(std::floor(lines)) - first_row_; }
  static std::int64_t column(double lines) { return std::int64_t(std::floor(lines)); }

  double side_, low_ = 1e300, high_ = -1e300;
  std::int64_t first_row_ = 0;
  std::vector<std::vector<double>> crossings_;
  std::vector<std::vector<Columns>> touched_;
};

/// More runs than this would cost more than they save; the longest are kept.
constexpr std::size_t kMostRuns = 1500;

std::vector<Run> longest_runs(const Outline& outline, double side) {
  std::vector<Run> runs = Raster(outline, side).runs();
  if (runs.size() > kMostRuns) {
    auto longer = [](const Run& p, const Run& q) { return p.last - p.first > q.last - q.first; };
    std::nth_element(runs.begin(), runs.begin() + kMostRuns, runs.end(), longer);
    runs.resize(kMostRuns);
  }
  return runs;
}

}  // namespace

std::int64_t InnerMask::line_of(double v) const {
  return std::int64_t(std::floor((v - double(side_ / 2)) / double(side_)));
}

InnerMask::InnerMask(std::span<const Pair> pairs, std::int64_t side) : side_(side) {
  std::vector<std::pair<std::vector<Run>, std::vector<Run>>> rasters;
  std::int64_t c0 = INT64_MAX, c1 = INT64_MIN, r0 = INT64_MAX, r1 = INT64_MIN;
  for (const Pair& p : pairs) {
    auto& made = rasters.emplace_back(longest_runs(*p.a, double(side)), longest_runs(*p.b, double(side)));
    auto bounds = [](const std::vector<Run>& runs, auto get, bool most) {
      std::int64_t v = most ? INT64_MIN : INT64_MAX;
      for (const Run& r : runs) v = most ? std::max(v, get(r)) : std::min(v, get(r));
      return v;
    };
    if (made.first.empty() || made.second.empty()) continue;
    auto row = [](const Run& r) { return r.row; };
    auto first = [](const Run& r) { return r.first; };
    auto last = [](const Run& r) { return r.last; };
    c0 = std::min(c0, bounds(made.first, first, false) + bounds(made.second, first, false));
    c1 = std::max(c1, bounds(made.first, last, true) + bounds(made.second, last, true));
    r0 = std::min(r0, bounds(made.first, row, false) + bounds(made.second, row, false));
    r1 = std::max(r1, bounds(made.first, row, true) + bounds(made.second, row, true));
  }
  if (c0 > c1) return;
  column0_ = c0, row0_ = r0, columns_ = c1 - c0 + 2, rows_ = r1 - r0 + 1;
  in_.assign(std::size_t(columns_ * rows_), 0);
  for (const auto& [a, b] : rasters)
    for (const Run& p : a)
      for (const Run& q : b) {
        std::int32_t* line = in_.data() + (p.row + q.row - row0_) * columns_ - column0_;
        ++line[p.first + q.first];
        --line[p.last + q.last + 1];
      }
  for (std::int64_t r = 0; r < rows_; ++r)
    for (std::int64_t c = 1; c < columns_; ++c)
      in_[std::size_t(r * columns_ + c)] += in_[std::size_t(r * columns_ + c - 1)];
}

}  // namespace findspace::plane
