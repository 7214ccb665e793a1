// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signs of the open cells of a row. Cells of winding number 0 on neighbouring lines are one cell where a level of
// the strip between the lines is free of facets; each joined set that does not reach the outside is tested once.
// Guarantee: exact: what joins is certain, and each test is exact. Cost: linear in the cells, and the tests.
// Internal to ray_pair.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "space/convolution/ray_pair.h"
#include "space/convolution/ray_row_groups.h"

namespace findspace::space {

/// Whether the interiors meet at a place; of a solid by itself they never do: all that is asked lies outside or on its
/// surface.
struct RowTest {
  const std::optional<RayOverlap>& overlap;
  RayCounts& counts;
  RayOverlap::Recent recent{};

  bool meets(const RowHits& hits, int column, const exact::Fraction& z) {
    return overlap && overlap->interiors_meet(ray_place(hits.sheets.grid().u_at(column), hits.y, z), recent);
  }
};

class RowCells {
 public:
  RowCells(RowHits& hits, RowGroups& row, RowTest& test) : hits_(hits), row_(row), test_(test) {}
  /// Gives every cell of the row its sign; `outside`: that of the outermost ones. May be called again, for the next
  /// row.
  void settle(std::int8_t outside);

 private:
  /// What is known of a set of joined cells: the sign of an outer cell in it, and otherwise its widest cell.
  struct Known {
    std::int8_t sign = 2;
    int column = -1, cell = -1;
    double width = -1;
  };

  void settle_walls(int column);
  bool strip_needed(int column) const { return row_.open[column] != 0 || row_.open[column + 1] != 0; }
  void join_cells();
  void collect_ranges();
  void join_over_edge(int column, std::span<std::pair<double, double>> ranges);
  void test_joined();

  RowHits& hits_;
  RowGroups& row_;
  RowTest& test_;
  std::vector<int> range_first_, next_;  // over the strip from column i to i + 1: ranges_ from range_first_[i] on
  std::vector<std::pair<double, double>> ranges_;
  std::vector<int> root_;
  std::vector<Known> known_;
};

}  // namespace findspace::space
