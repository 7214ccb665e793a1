// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The places where the lines of a row meet facets, and the cells between: hits of one place form a group, and before,
// between and behind the groups of a line lie its cells. Guarantee: exact. Cost: linear in the hits.
// Internal to ray_pair.
#pragma once

#include <cstdint>
#include <vector>

#include "space/convolution/ray_row_hits.h"

namespace findspace::space {

/// A place on a line where it meets facets.
struct RayGroup {
  double at = 0, error = 0;
  int first = 0, count = 0;  // the facets met, in RowHits::sorted
  int exact = -1;            // its place in RowHits::exacts, once asked for
};

/// What lies after group k - 1 and before group k of a line.
struct RayCell {
  int winding = 0;
  bool wall = false;     // inside facets parallel to the lines
  std::int8_t sign = 2;  // 2: not known yet
};

/// Groups and cells of a row; both vectors are longer than what is in use: of one row after another.
struct RowGroups {
  std::vector<RayGroup> groups;
  std::vector<int> first;      // of column i: groups first[i] to first[i + 1] - 1
  std::vector<RayCell> cells;  // of column i from cells_of(i) on, one more than groups
  std::vector<char> open;      // whether a column has cells that winding numbers do not decide

  int cells_of(int column) const { return first[column] + column; }
  int groups_of(int column) const { return first[column + 1] - first[column]; }
  RayGroup& group(int column, int k) { return groups[first[column] + k]; }
  const RayGroup& group(int column, int k) const { return groups[first[column] + k]; }
  /// The cell that holds a level of a line; -1 where a group may be there.
  int cell_at(int column, double level) const;
};

/// Where group k of a line is, exactly; kept for the next time.
exact::Fraction place(RowHits& hits, RowGroups& row, int column, int k);

/// Makes groups and cells of all columns. `base_winding`: far below.
void group_hits(RowHits& hits, int base_winding, RowGroups& row);

}  // namespace findspace::space
