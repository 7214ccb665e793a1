// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_row_groups.h"

#include <algorithm>

namespace findspace::space {
namespace {

void group_column(const RowHits& hits, int base_winding, RowGroups& row, int column) {
  const RowHit *hit = hits.sorted.data() + hits.first[column], *end = hits.sorted.data() + hits.first[column + 1];
  RayGroup* group = row.groups.data() + row.first[column];
  RayCell* cell = row.cells.data() + row.cells_of(column);
  int winding = base_winding;
  bool open = false;
  *cell = {winding, false, 2};
  while (hit != end) {
    const RowHit* first = hit;
    do {
      winding += hit++->jump;
    } while (hit != end && coincide(hits, *(hit - 1), *hit));
    *group++ = {first->at, first->error, static_cast<int>(first - hits.sorted.data()), static_cast<int>(hit - first),
                -1};
    *++cell = {winding, false, static_cast<std::int8_t>(winding != 0 ? -1 : 2)};
    open = open || (winding == 0 && hit != end);
  }
  row.open[column] = open;
  row.first.push_back(static_cast<int>(group - row.groups.data()));
}

void mark_walls(RowHits& hits, RowGroups& row, int column) {
  const int count = row.groups_of(column);
  for (const RowWall& w : hits.walls[hits.dirty_number[column]]) {
    for (int k = 0; k + 1 < count; ++k) {
      if (exact::compare_fractions(w.from, place(hits, row, column, k)) <= 0 &&
          exact::compare_fractions(place(hits, row, column, k + 1), w.to) <= 0) {
        row.cells[row.cells_of(column) + k + 1].wall = true;
        row.cells[row.cells_of(column) + k + 1].sign = 2;
      }
    }
  }
}

}  // namespace

int RowGroups::cell_at(int column, double level) const {
  const auto begin = groups.begin() + first[column], end = groups.begin() + first[column + 1];
  const auto g = std::partition_point(begin, end, [&](const RayGroup& x) { return x.at < level; });
  if (g != end && !(g->at - g->error > level)) return -1;
  if (g != begin && !((g - 1)->at + (g - 1)->error < level)) return -1;
  return first[column] + column + static_cast<int>(g - begin);
}

exact::Fraction place(RowHits& hits, RowGroups& row, int column, int k) {
  RayGroup& g = row.group(column, k);
  if (g.exact < 0) {
    hits.exacts.push_back(place(hits, hits.sorted[g.first]));
    g.exact = static_cast<int>(hits.exacts.size()) - 1;
  }
  return hits.exacts[g.exact];
}

void group_hits(RowHits& hits, int base_winding, RowGroups& row) {
  row.first.assign(1, 0);
  row.open.assign(hits.columns, 0);
  row.groups.resize(std::max(row.groups.size(), hits.sorted.size()));
  row.cells.resize(std::max(row.cells.size(), hits.sorted.size() + hits.columns));
  for (int i = 0; i < hits.columns; ++i) {
    group_column(hits, base_winding, row, i);
    if (hits.dirty[i]) mark_walls(hits, row, i);
  }
}

}  // namespace findspace::space
