// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signs of the open cells of a row. Cells of winding number 0 on neighbouring lines are one cell where a level of
// the strip between the lines is free of facets; each joined set that does not reach the outside is tested once.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/number/margins.h"
#include "space/convolution/ray_row.h"

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
  const double loose =
      s.z_error * 4 + std::fabs(slope) * 8 * s.x_error + margin::kRoundings32 * (std::fabs(low) + std::fabs(high));
  const double a = s.z[0] + slope * (x0 - s.x[0]), b = s.z[0] + slope * (x1 - s.x[0]);
  return {std::max(low, std::min(a, b) - loose), std::min(high, std::max(a, b) + loose)};
}

}  // namespace

void RowWork::settle_cells() {
  // Outside everything the bodies are apart, or B lies in the complement.
  const std::int8_t outside = pair_.complement_ ? -1 : 1;
  bool open = false;
  for (int i = 0; i < columns_; ++i) {
    cells_[cells_of(i)].sign = cells_[cells_of(i) + groups_of(i)].sign = outside;
    open = open || open_[i];
  }
  if (open) {
    join_cells();
    test_joined();
  }
  for (int i = 0; i < columns_; ++i) {
    if (dirty_[i]) settle_walls(i);
  }
}

void RowWork::settle_walls(int column) {
  for (int k = 1; k < groups_of(column); ++k) {
    RayCell& cell = cells_[cells_of(column) + k];
    if (!cell.wall) continue;
    ++pair_.counts_.wall_tests;
    cell.sign = meets(column, exact::between(place(column, k - 1), place(column, k))) ? -1 : 0;
  }
}

void RowWork::join_cells() {
  root_.resize(cells_.size());
  std::iota(root_.begin(), root_.begin() + group_first_.back() + columns_, 0);
  collect_ranges();
  for (int i = 0; i + 1 < columns_; ++i) {
    if (strip_needed(i)) join_over_edge(i, {ranges_.data() + range_first_[i], ranges_.data() + range_first_[i + 1]});
  }
}

/// The heights of the sections over each strip that is needed.
void RowWork::collect_ranges() {
  const auto each_strip = [&](auto take) {
    for (const Cut& c : cuts_) {
      const int last = std::min(c.section.column[1], columns_ - 1);
      for (int i = std::max(c.section.column[0] - 1, 0); i < last; ++i) {
        if (strip_needed(i)) take(c.section, i);
      }
    }
  };
  range_first_.assign(columns_ + 1, 0);
  each_strip([&](const Section&, int i) { ++range_first_[i + 1]; });
  for (int i = 0; i < columns_; ++i) range_first_[i + 1] += range_first_[i];
  next_.assign(range_first_.begin(), range_first_.end() - 1);
  ranges_.resize(range_first_.back());
  each_strip([&](const Section& s, int i) {
    const double x0 = static_cast<double>(sheets_.grid().u_at(i)), x1 = static_cast<double>(sheets_.grid().u_at(i + 1));
    ranges_[next_[i]++] = part_range(s, std::max(x0, s.x[0]), std::min(x1, s.x[1]));
  });
}

int RowWork::cell_at(int column, double level) const {
  const auto begin = groups_.begin() + group_first_[column], end = groups_.begin() + group_first_[column + 1];
  const auto g = std::partition_point(begin, end, [&](const RayGroup& x) { return x.at < level; });
  if (g != end && !(g->at - g->error > level)) return -1;
  if (g != begin && !((g - 1)->at + (g - 1)->error < level)) return -1;
  return group_first_[column] + column + static_cast<int>(g - begin);
}

void RowWork::join_over_edge(int column, std::span<std::pair<double, double>> ranges) {
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

/// Only what columns with undecided cells and their neighbours hold: no other cell is joined to those.
void RowWork::test_joined() {
  known_.resize(cells_.size());
  const auto each_column = [&](auto visit) {
    for (int i = 0; i < columns_; ++i) {
      if (open_[i] || (i > 0 && open_[i - 1]) || (i + 1 < columns_ && open_[i + 1]))
        visit(i, cells_of(i), groups_of(i));
    }
  };
  each_column([&](int, int cells, int count) { std::fill_n(known_.begin() + cells, count + 1, Known{}); });
  each_column([&](int i, int cells, int count) {
    for (int k = 0; k <= count; ++k) {
      const RayCell& cell = cells_[cells + k];
      if (cell.wall || cell.winding != 0) continue;
      Known& set = known_[find(root_, cells + k)];
      if (cell.sign != 2) set.sign = cell.sign;
      if (k == 0 || k == count) continue;
      const double width = groups_[group_first_[i] + k].at - groups_[group_first_[i] + k - 1].at;
      if (width > set.width) set = {set.sign, i, k, width};
    }
  });
  each_column([&](int, int cells, int count) {
    for (int c = cells; c <= cells + count; ++c) {
      Known& set = known_[c];
      if (set.sign != 2 || set.column < 0) continue;
      ++pair_.counts_.cell_tests;
      const Fraction z = exact::between(place(set.column, set.cell - 1), place(set.column, set.cell));
      set.sign = meets(set.column, z) ? -1 : 1;
    }
  });
  each_column([&](int, int cells, int count) {
    for (int c = cells; c <= cells + count; ++c) {
      if (cells_[c].sign == 2 && !cells_[c].wall) cells_[c].sign = known_[find(root_, c)].sign;
    }
  });
}

}  // namespace findspace::space
