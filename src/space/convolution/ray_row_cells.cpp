// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_row_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/margins/rounding.h"

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

void RowCells::settle(std::int8_t outside) {
  bool open = false;
  for (int i = 0; i < hits_.columns; ++i) {
    row_.cells[row_.cells_of(i)].sign = row_.cells[row_.cells_of(i) + row_.groups_of(i)].sign = outside;
    open = open || row_.open[i];
  }
  if (open) {
    join_cells();
    test_joined();
  }
  for (int i = 0; i < hits_.columns; ++i) {
    if (hits_.dirty[i]) settle_walls(i);
  }
}

void RowCells::settle_walls(int column) {
  for (int k = 1; k < row_.groups_of(column); ++k) {
    RayCell& cell = row_.cells[row_.cells_of(column) + k];
    if (!cell.wall) continue;
    ++test_.counts.wall_tests;
    cell.sign =
        test_.meets(hits_, column, exact::between(place(hits_, row_, column, k - 1), place(hits_, row_, column, k)))
            ? -1
            : 0;
  }
}

void RowCells::join_cells() {
  root_.resize(row_.cells.size());
  std::iota(root_.begin(), root_.begin() + row_.first.back() + hits_.columns, 0);
  collect_ranges();
  for (int i = 0; i + 1 < hits_.columns; ++i) {
    if (strip_needed(i)) join_over_edge(i, {ranges_.data() + range_first_[i], ranges_.data() + range_first_[i + 1]});
  }
}

/// The heights of the sections over each strip that is needed.
void RowCells::collect_ranges() {
  const auto each_strip = [&](auto take) {
    for (const RowCut& c : hits_.cuts) {
      const int last = std::min(c.section.column[1], hits_.columns - 1);
      for (int i = std::max(c.section.column[0] - 1, 0); i < last; ++i) {
        if (strip_needed(i)) take(c.section, i);
      }
    }
  };
  range_first_.assign(hits_.columns + 1, 0);
  each_strip([&](const Section&, int i) { ++range_first_[i + 1]; });
  for (int i = 0; i < hits_.columns; ++i) range_first_[i + 1] += range_first_[i];
  next_.assign(range_first_.begin(), range_first_.end() - 1);
  ranges_.resize(range_first_.back());
  each_strip([&](const Section& s, int i) {
    const double x0 = static_cast<double>(hits_.sheets.grid().u_at(i)),
                 x1 = static_cast<double>(hits_.sheets.grid().u_at(i + 1));
    ranges_[next_[i]++] = part_range(s, std::max(x0, s.x[0]), std::min(x1, s.x[1]));
  });
}

void RowCells::join_over_edge(int column, std::span<std::pair<double, double>> ranges) {
  std::sort(ranges.begin(), ranges.end());
  double top = ranges.empty() ? 0 : ranges[0].first - 2;
  const auto try_gap = [&](double low, double high) {
    const double level = low + (high - low) / 2;
    if (!(low < level && level < high)) return;
    const int a = row_.cell_at(column, level), b = row_.cell_at(column + 1, level);
    if (a < 0 || b < 0 || row_.cells[a].wall || row_.cells[b].wall || row_.cells[a].winding != 0 ||
        row_.cells[b].winding != 0)
      return;
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
void RowCells::test_joined() {
  known_.resize(row_.cells.size());
  const auto each_column = [&](auto visit) {
    for (int i = 0; i < hits_.columns; ++i) {
      if (row_.open[i] || (i > 0 && row_.open[i - 1]) || (i + 1 < hits_.columns && row_.open[i + 1]))
        visit(i, row_.cells_of(i), row_.groups_of(i));
    }
  };
  each_column([&](int, int cells, int count) { std::fill_n(known_.begin() + cells, count + 1, Known{}); });
  each_column([&](int i, int cells, int count) {
    for (int k = 0; k <= count; ++k) {
      const RayCell& cell = row_.cells[cells + k];
      if (cell.wall || cell.winding != 0) continue;
      Known& set = known_[find(root_, cells + k)];
      if (cell.sign != 2) set.sign = cell.sign;
      if (k == 0 || k == count) continue;
      const double width = row_.group(i, k).at - row_.group(i, k - 1).at;
      if (width > set.width) set = {set.sign, i, k, width};
    }
  });
  each_column([&](int, int cells, int count) {
    for (int c = cells; c <= cells + count; ++c) {
      Known& set = known_[c];
      if (set.sign != 2 || set.column < 0) continue;
      ++test_.counts.cell_tests;
      const Fraction z =
          exact::between(place(hits_, row_, set.column, set.cell - 1), place(hits_, row_, set.column, set.cell));
      set.sign = test_.meets(hits_, set.column, z) ? -1 : 1;
    }
  });
  each_column([&](int, int cells, int count) {
    for (int c = cells; c <= cells + count; ++c) {
      if (row_.cells[c].sign == 2 && !row_.cells[c].wall) row_.cells[c].sign = known_[find(root_, c)].sign;
    }
  });
}

}  // namespace findspace::space
