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

std::int64_t floor_of(double v) { return std::int64_t(std::floor(v)); }

double x_at(const LatticeEdge& e, double y) { return e.x0 + (e.x1 - e.x0) * ((y - e.y0) / (e.y1 - e.y0)); }

/// A sorted list for every row.
template <class Item>
class Rows {
 public:
  void add(std::int64_t row, Item item) {
    low_ = std::min(low_, row);
    high_ = std::max(high_, row);
    entries_.push_back({row, item});
  }

  /// Calls f(row, items).
  template <class F>
  void each(F&& f) const {
    if (entries_.empty()) return;
    std::vector<std::size_t> start(std::size_t(high_ - low_ + 2), 0);
    for (const auto& [row, item] : entries_) ++start[std::size_t(row - low_ + 1)];
    for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
    std::vector<Item> items(entries_.size());
    std::vector<std::size_t> at(start);
    for (const auto& [row, item] : entries_) items[at[std::size_t(row - low_)]++] = item;
    for (std::size_t k = 0; k + 1 < start.size(); ++k) {
      std::span list(items.data() + start[k], items.data() + start[k + 1]);
      std::sort(list.begin(), list.end());
      f(low_ + std::int64_t(k), std::span<const Item>(list));
    }
  }

 private:
  std::int64_t low_ = INT64_MAX, high_ = INT64_MIN;
  std::vector<std::pair<std::int64_t, Item>> entries_;
};

/// Where an edge crosses the middle of a row, or the columns it touches there; crossings come first.
struct Mark {
  double x;
  std::int64_t first, last;
  bool crossing;
  bool operator<(const Mark& o) const {
    return crossing != o.crossing ? crossing : crossing ? x < o.x : first < o.first;
  }
};

void enter_cells(const LatticeEdge& e, double side, Rows<Mark>& rows) {
  double y0 = std::min(e.y0, e.y1), y1 = std::max(e.y0, e.y1);
  std::int64_t last = floor_of(y1 / side + margin::kLatticeSlack);
  for (std::int64_t r = floor_of(y0 / side - margin::kLatticeSlack); r <= last; ++r) {
    double bottom = double(r) * side, low = std::clamp(bottom, y0, y1), high = std::clamp(bottom + side, y0, y1);
    double xa = y0 == y1 ? e.x0 : x_at(e, low), xb = y0 == y1 ? e.x1 : x_at(e, high);
    rows.add(r, {0, floor_of(std::min(xa, xb) / side - margin::kLatticeSlack),
                 floor_of(std::max(xa, xb) / side + margin::kLatticeSlack), false});
    double middle = bottom + side / 2;
    if (y0 <= middle && middle < y1) rows.add(r, {x_at(e, middle), 0, 0, true});
  }
}

/// Between the crossings, the cells no edge touches.
void add_cells(std::int64_t row, std::span<const Mark> marks, double side, std::vector<LatticeRun>& out) {
  auto touched = std::find_if(marks.begin(), marks.end(), [](const Mark& m) { return !m.crossing; });
  std::int64_t at = INT64_MIN;  // everything to the left is passed or touched
  for (auto k = marks.begin(); k < touched && k + 1 < marks.end() && k[1].crossing; k += 2) {
    std::int64_t end = floor_of(k[1].x / side);
    at = std::max(at, floor_of(k[0].x / side));
    for (auto t = touched; t != marks.end() && t->first <= end; touched = ++t) {
      if (t->first > at) out.push_back({row, at, t->first - 1});
      at = std::max(at, t->last + 1);
    }
    if (at <= end) out.push_back({row, at, end});
  }
}

}  // namespace

std::vector<LatticeRun> cell_runs(const Outline& outline, double side) {
  Rows<Mark> rows;
  for (const LatticeEdge& e : outline) enter_cells(e, side, rows);
  std::vector<LatticeRun> out;
  rows.each([&](std::int64_t row, std::span<const Mark> marks) { add_cells(row, marks, side, out); });
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
  rows.each([&](std::int64_t row, std::span<const double> x) {
    for (std::size_t k = 0; k + 1 < x.size(); k += 2) {
      auto first = std::int64_t(std::ceil(x[k] / side + margin::kLatticeSlack)),
           last = floor_of(x[k + 1] / side - margin::kLatticeSlack);
      if (first <= last) out.push_back({row, first, last});
    }
  });
  return out;
}

}  // namespace findspace::plane
