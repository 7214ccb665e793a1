// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signs of the open cells of a row. Cells of winding number 0 on neighbouring lines are one cell where a level of
// the strip between the lines is free of facets; each joined set that does not reach the outside is tested once.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "space/ray_row.h"

namespace findspace::space {

using exact::Fraction;

namespace {

int find(std::vector<int>& root, int k) {
  while (root[k] != k) k = root[k] = root[root[k]];
  return k;
}

/// The part of a section between x0 and x1 in height, widened by its errors.
std::pair<double, double> part_range(const Section& s, double x0, double x1) {
  const double width = s.x[1] - s.x[0];
  const double low = std::min(s.z[0], s.z[1]) - s.z_error, high = std::max(s.z[0], s.z[1]) + s.z_error;
  if (!(width > 4 * s.x_error)) return {low, high};
  const double slope = (s.z[1] - s.z[0]) / width;
  const double loose = s.z_error * 4 + std::fabs(slope) * 8 * s.x_error + 0x1p-48 * (std::fabs(low) + std::fabs(high));
  const double a = s.z[0] + slope * (x0 - s.x[0]), b = s.z[0] + slope * (x1 - s.x[0]);
  return {std::max(low, std::min(a, b) - loose), std::min(high, std::max(a, b) + loose)};
}

}  // namespace

void RowWork::settle_cells() {
  // Outside everything the bodies are apart, or B lies in the complement.
  const std::int8_t outside = pair_.complement_ ? -1 : 1;
  bool open = false;
  for (int i = 0; i < columns_; ++i) {
    const int cells = group_first_[i] + i, count = group_first_[i + 1] - group_first_[i];
    cells_[cells].sign = cells_[cells + count].sign = outside;
    for (int k = 1; k < count; ++k) {
      RayCell& cell = cells_[cells + k];
      if (!cell.wall && cell.winding != 0) cell.sign = -1;
      open = open || (!cell.wall && cell.winding == 0);
    }
  }
  if (open) {
    join_cells();
    test_joined();
  }
  for (int i = 0; i < columns_; ++i) {
    if (!dirty_[i]) continue;
    const int cells = group_first_[i] + i, count = group_first_[i + 1] - group_first_[i];
    for (int k = 1; k < count; ++k) {
      if (!cells_[cells + k].wall) continue;
      ++pair_.counts_.wall_tests;
      cells_[cells + k].sign = meets(i, exact::between(place(i, k - 1), place(i, k))) ? -1 : 0;
    }
  }
}

void RowWork::join_cells() {
  root_.resize(cells_.size());
  std::iota(root_.begin(), root_.end(), 0);
  std::vector<char> open(columns_ + 1, 0);
  for (int i = 0; i < columns_; ++i) {
    for (int c = group_first_[i] + i; c <= group_first_[i + 1] + i; ++c)
      open[i] |= cells_[c].sign == 2 && !cells_[c].wall;
  }
  std::vector<std::vector<std::pair<double, double>>> ranges(columns_);  // over the strip from column i to i + 1
  const auto needed = [&](int i) { return i >= 0 && i + 1 < columns_ && (open[i] || open[i + 1]); };
  for (const int k : sheets_.row(j_)) {
    Section s;
    if (!sheets_.section(k, j_, s)) continue;
    for (int i = s.column[0] - 1; i < s.column[1]; ++i) {
      if (!needed(i)) continue;
      const double x0 = static_cast<double>(sheets_.grid().u_at(i)),
                   x1 = static_cast<double>(sheets_.grid().u_at(i + 1));
      ranges[i].push_back(part_range(s, std::max(x0, s.x[0]), std::min(x1, s.x[1])));
    }
  }
  for (int i = 0; i + 1 < columns_; ++i) {
    if (needed(i)) join_over_edge(i, ranges[i]);
  }
}

int RowWork::cell_at(int column, double level) const {
  const auto begin = groups_.begin() + group_first_[column], end = groups_.begin() + group_first_[column + 1];
  const auto g = std::partition_point(begin, end, [&](const RayGroup& x) { return x.at < level; });
  if (g != end && !(g->at - g->error > level)) return -1;
  if (g != begin && !((g - 1)->at + (g - 1)->error < level)) return -1;
  return group_first_[column] + column + static_cast<int>(g - begin);
}

void RowWork::join_over_edge(int column, std::vector<std::pair<double, double>>& ranges) {
  std::sort(ranges.begin(), ranges.end());
  double top = ranges.empty() ? 0 : ranges[0].first - 2;
  const auto try_gap = [&](double low, double high) {
    const double level = low + (high - low) / 2;
    if (!(low < level && level < high)) return;
    const int a = cell_at(column, level), b = cell_at(column + 1, level);
    if (a < 0 || b < 0 || cells_[a].wall || cells_[b].wall || cells_[a].winding != 0 || cells_[b].winding != 0) return;
    const int p = find(root_, a), q = find(root_, b);
    root_[std::max(p, q)] = std::min(p, q);
  };
  for (const auto& [low, high] : ranges) {
    if (low > top) try_gap(top, low);
    top = std::max(top, high);
  }
  if (!ranges.empty()) try_gap(top, top + 2);
}

void RowWork::test_joined() {
  // What is known of a set: the sign of an outer cell in it, and otherwise its widest cell.
  struct Known {
    std::int8_t sign = 2;
    int column = -1, cell = -1;
    double width = -1;
  };
  std::vector<Known> known(cells_.size());
  for (int i = 0; i < columns_; ++i) {
    const int cells = group_first_[i] + i, count = group_first_[i + 1] - group_first_[i];
    for (int k = 0; k <= count; ++k) {
      const RayCell& cell = cells_[cells + k];
      if (cell.wall || cell.winding != 0) continue;
      Known& set = known[find(root_, cells + k)];
      if (cell.sign != 2) set.sign = cell.sign;
      if (k == 0 || k == count) continue;
      const double width = groups_[group_first_[i] + k].at - groups_[group_first_[i] + k - 1].at;
      if (width > set.width) set = {set.sign, i, k, width};
    }
  }
  for (std::size_t c = 0; c < known.size(); ++c) {
    Known& set = known[c];
    if (set.sign != 2 || set.column < 0) continue;
    ++pair_.counts_.cell_tests;
    set.sign = meets(set.column, exact::between(place(set.column, set.cell - 1), place(set.column, set.cell))) ? -1 : 1;
  }
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (cells_[c].sign == 2 && !cells_[c].wall) cells_[c].sign = known[find(root_, static_cast<int>(c))].sign;
  }
}

}  // namespace findspace::space
