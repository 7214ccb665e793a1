// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/lattice_runs.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

double x_at(const LatticeEdge& e, double y) { return e.x0 + (e.x1 - e.x0) * ((y - e.y0) / (e.y1 - e.y0)); }

/// A list for every row.
template <class Item>
class Rows {
 public:
  void add(std::int64_t row, Item item) {
    low_ = std::min(low_, row);
    high_ = std::max(high_, row);
    entries_.push_back({row, item});
  }

  /// Puts each list in order; no more is added.
  void sort() {
    if (entries_.empty()) return;
    start_.assign(std::size_t(high_ - low_ + 2), 0);
    for (const auto& [row, item] : entries_) ++start_[std::size_t(row - low_ + 1)];
    for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
    items_.resize(entries_.size());
    std::vector<std::size_t> at(start_);
    for (const auto& [row, item] : entries_) items_[at[std::size_t(row - low_)]++] = item;
    entries_.clear();
    for (std::int64_t row = low_; row <= high_; ++row) {
      const std::span<Item> list = list_of(row);
      std::sort(list.begin(), list.end());
    }
  }

  std::span<const Item> of(std::int64_t row) { return row < low_ || row > high_ ? std::span<Item>() : list_of(row); }
  /// Calls f(row, list).
  template <class F>
  void each(F&& f) {
    for (std::int64_t row = low_; row <= high_; ++row) f(row, of(row));
  }

 private:
  std::span<Item> list_of(std::int64_t row) {
    const auto k = std::size_t(row - low_);
    return std::span(items_).subspan(start_[k], start_[k + 1] - start_[k]);
  }

  std::int64_t low_ = INT64_MAX, high_ = INT64_MIN;
  std::vector<std::pair<std::int64_t, Item>> entries_;
  std::vector<std::size_t> start_;  // of each row's
  std::vector<Item> items_;
};

/// Columns of a row.
struct Touched {
  std::int64_t first, last;
  bool operator<(const Touched& o) const { return first < o.first; }
};

/// Where an edge crosses the middle of rows, and the cells it touches there.
void enter_cells(const LatticeEdge& e, double side, Rows<double>& crossings, Rows<Touched>& touched) {
  const double y0 = std::min(e.y0, e.y1), y1 = std::max(e.y0, e.y1);
  const bool level = y0 == y1;
  const auto column_at = [&](double y) { return x_at(e, std::clamp(y, y0, y1)) / side; };
  const std::int64_t first = floor_of(y0 / side - margin::kLatticeSlack);
  const std::int64_t last = floor_of(y1 / side + margin::kLatticeSlack);
  double below = level ? e.x0 / side : column_at(double(first) * side);
  for (std::int64_t r = first; r <= last; ++r) {
    const double bottom = double(r) * side, middle = bottom + side / 2;
    const double above = level ? e.x1 / side : column_at(bottom + side);
    touched.add(r, {floor_of(std::min(below, above) - margin::kLatticeSlack),
                    floor_of(std::max(below, above) + margin::kLatticeSlack)});
    if (y0 <= middle && middle < y1) crossings.add(r, x_at(e, middle));
    if (!level) below = above;
  }
}

/// Between the crossings, the cells no edge touches.
void add_cells(std::int64_t row, std::span<const double> crossings, std::span<const Touched> touched, double side,
               std::vector<LatticeRun>& out) {
  auto next = touched.begin();
  std::int64_t at = INT64_MIN;  // everything to the left is passed or touched
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const std::int64_t end = floor_of(crossings[k + 1] / side);
    at = std::max(at, floor_of(crossings[k] / side));
    for (; next != touched.end() && next->first <= end; ++next) {
      if (next->first > at) out.push_back({row, at, next->first - 1});
      at = std::max(at, next->last + 1);
    }
    if (at <= end) out.push_back({row, at, end});
  }
}

}  // namespace

std::vector<LatticeRun> cell_runs(const Outline& outline, double side) {
  Rows<double> crossings;
  Rows<Touched> touched;
  for (const LatticeEdge& e : outline) enter_cells(e, side, crossings, touched);
  crossings.sort();
  touched.sort();
  std::vector<LatticeRun> out;
  crossings.each([&](std::int64_t row, std::span<const double> x) { add_cells(row, x, touched.of(row), side, out); });
  return out;
}

std::vector<LatticeRun> point_runs(const Outline& outline, double side) {
  // Just above a row its points lie between the crossings; the polygon is closed, so they belong to it in the row too.
  Rows<double> rows;
  for (const LatticeEdge& e : outline) {
    double y0 = std::min(e.y0, e.y1), y1 = std::max(e.y0, e.y1);
    for (std::int64_t r = std::int64_t(std::ceil(y0 / side)) - 1; double(r) * side < y1; ++r)
      if (y0 <= double(r) * side) rows.add(r, x_at(e, double(r) * side));
  }
  std::vector<LatticeRun> out;
  rows.sort();
  rows.each([&](std::int64_t row, std::span<const double> x) {
    for (std::size_t k = 0; k + 1 < x.size(); k += 2) {
      const std::int64_t first = -floor_of(-(x[k] / side + margin::kLatticeSlack));
      const std::int64_t last = floor_of(x[k + 1] / side - margin::kLatticeSlack);
      if (first <= last) out.push_back({row, first, last});
    }
  });
  return out;
}

}  // namespace findspace::plane
