// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_row.h"

namespace findspace::space {

RowWork::RowWork(const PairRays& pair)
    : pair_(pair), hits_(*pair.sheets_), test_{pair.overlap_, pair.counts_}, cells_(hits_, row_, test_) {}

RayRow RowWork::run(int j) {
  find_hits(hits_, j);
  group_hits(hits_, pair_.base_winding_, row_);
  // Outside everything the bodies are apart, or B lies in the complement.
  cells_.settle(pair_.complement_ ? -1 : 1);
  RayRow row;
  row.before.reserve(hits_.columns);
  row.first.reserve(hits_.columns + 1);
  row.events.reserve(row_.first.back());
  for (int i = 0; i < hits_.columns; ++i) emit(i, row);
  pair_.counts_.dirty_lines += static_cast<std::int64_t>(hits_.walls.size());
  pair_.counts_.hits += static_cast<std::int64_t>(hits_.sorted.size());
  return row;
}

/// On a facet, so touching at least. Beside a place that is not in the open set U it is not in U either.
inline std::int8_t RowWork::sign_here(int column, int group) {
  const int cell = row_.cells_of(column) + group;
  if (row_.cells[cell].sign != -1 || row_.cells[cell + 1].sign != -1) return 0;
  const RayGroup& g = row_.group(column, group);
  if (g.count == 1 && !hits_.sorted[g.first].touch) return -1;  // one sheet: what overlaps on one side goes on
  return sign_between(column, group);
}

/// On several facets or at the edge of one, between cells of U.
std::int8_t RowWork::sign_between(int column, int group) {
  const RayGroup& g = row_.group(column, group);
  // Where everything overlapping before would come apart here, the sheets that are left upward take all of the winding.
  int left = row_.cells[row_.cells_of(column) + group].winding;
  bool plane = true;
  const Wide3 normal = hits_.sheets[hits_.sorted[g.first].sheet].facet.normal();
  for (int h = g.first; h < g.first + g.count; ++h) {
    const Sheet& s = hits_.sheets[hits_.sorted[h].sheet];
    plane = plane && !hits_.sorted[h].touch && exact::lexicographic_sign_cross(normal, s.facet.normal()) == 0;
    if (s.jump * s.facet.weight < 0) left += hits_.sorted[h].jump;
  }
  if (plane && left != 0) return -1;
  ++test_.counts.sheet_tests;
  return test_.meets(hits_, column, place(hits_, row_, column, group)) ? -1 : 0;
}

void RowWork::emit(int column, RayRow& row) {
  const RayCell* cells = row_.cells.data() + row_.cells_of(column);
  const int count = row_.groups_of(column), sense = pair_.complement_ ? -1 : 1;
  std::int8_t before = cells[0].sign;
  row.before.push_back(static_cast<std::int8_t>(sense * before));
  for (int k = 0; k < count; ++k) {
    const std::int8_t here = sign_here(column, k), after = cells[k + 1].sign;
    if (here == before && after == before) continue;
    const RayGroup& g = row_.group(column, k);
    RayEvent& event = row.events.emplace_back();
    event.at.exact = g.exact >= 0 ? hits_.exacts[g.exact] : place(hits_, hits_.sorted[g.first]);
    event.at.value = g.at;
    event.at.radius = g.error;
    event.here = static_cast<std::int8_t>(sense * here);
    event.after = static_cast<std::int8_t>(sense * after);
    before = after;
  }
  row.first.push_back(static_cast<int>(row.events.size()));
}

}  // namespace findspace::space
