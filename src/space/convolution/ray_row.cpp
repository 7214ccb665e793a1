// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_row.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/number/margins.h"

namespace findspace::space {

using exact::Fraction;

RowWork::RowWork(const PairRays& pair) : pair_(pair), sheets_(*pair.sheets_), columns_(pair.grid().nu) {}

RayRow RowWork::run(int j) {
  j_ = j;
  y_ = sheets_.grid().v_at(j);
  dirty_.assign(columns_, 0);
  exacts_.clear();
  walls_.clear();
  find_sections();
  collect();
  group_first_.assign(1, 0);
  open_.assign(columns_, 0);
  groups_.resize(std::max(groups_.size(), sorted_.size()));
  cells_.resize(std::max(cells_.size(), sorted_.size() + columns_));
  for (int i = 0; i < columns_; ++i) {
    sort_column(i);
    group_column(i);
    if (dirty_[i]) mark_walls(i, walls_[dirty_number_[i]]);
  }
  settle_cells();
  RayRow row;
  row.before.reserve(columns_);
  row.first.reserve(columns_ + 1);
  row.events.reserve(group_first_.back());
  for (int i = 0; i < columns_; ++i) emit(i, row);
  pair_.counts_.hits += static_cast<std::int64_t>(sorted_.size());
  return row;
}

RowWork::Hit RowWork::exact_hit(int column, int sheet, const Fraction& z, int jump, bool touch) {
  const double at = exact::to_double(z);
  exacts_.push_back(z);
  return {at,    margin::kRoundings8 * (std::fabs(at) + 1), column,
          sheet, static_cast<int>(exacts_.size()) - 1,      static_cast<std::int8_t>(jump),
          touch};
}

Fraction RowWork::place(const Hit& h) const {
  return h.exact >= 0 ? exacts_[h.exact] : sheets_[h.sheet].height_exactly(sheets_.grid().u_at(h.column), y_);
}

int RowWork::compare_exactly(const Hit& a, const Hit& b) const { return exact::compare_fractions(place(a), place(b)); }

Fraction RowWork::place(int column, int group) {
  RayGroup& g = groups_[group_first_[column] + group];
  if (g.exact < 0) {
    exacts_.push_back(place(sorted_[g.first]));
    g.exact = static_cast<int>(exacts_.size()) - 1;
  }
  return exacts_[g.exact];
}

/// Of a solid by itself all that is asked lies outside or on its surface.
bool RowWork::meets(int column, const Fraction& z) {
  return pair_.overlap_ && pair_.overlap_->interiors_meet(ray_place(sheets_.grid().u_at(column), y_, z), recent_);
}

/// On a facet, so touching at least. Beside a place that is not in the open set U it is not in U either.
inline std::int8_t RowWork::sign_here(int column, int group) {
  const int cell = cells_of(column) + group;
  if (cells_[cell].sign != -1 || cells_[cell + 1].sign != -1) return 0;
  const RayGroup& g = groups_[group_first_[column] + group];
  if (g.count == 1 && !sorted_[g.first].touch) return -1;  // one sheet: what overlaps on one side goes on
  return sign_between(column, group);
}

/// On several facets or at the edge of one, between cells of U.
std::int8_t RowWork::sign_between(int column, int group) {
  const RayGroup& g = groups_[group_first_[column] + group];
  // Where everything overlapping before would come apart here, the sheets that are left upward take all of the winding.
  int left = cells_[cells_of(column) + group].winding;
  bool plane = true;
  const Wide3 normal = sheets_[sorted_[g.first].sheet].facet.normal();
  for (int h = g.first; h < g.first + g.count; ++h) {
    const Sheet& s = sheets_[sorted_[h].sheet];
    plane = plane && !sorted_[h].touch && exact::lexicographic_sign_cross(normal, s.facet.normal()) == 0;
    if (s.jump * s.facet.weight < 0) left += sorted_[h].jump;
  }
  if (plane && left != 0) return -1;
  ++pair_.counts_.sheet_tests;
  return meets(column, place(column, group)) ? -1 : 0;
}

void RowWork::emit(int column, RayRow& row) {
  const RayCell* cells = cells_.data() + cells_of(column);
  const int count = groups_of(column), sense = pair_.complement_ ? -1 : 1;
  std::int8_t before = cells[0].sign;
  row.before.push_back(static_cast<std::int8_t>(sense * before));
  for (int k = 0; k < count; ++k) {
    const std::int8_t here = sign_here(column, k), after = cells[k + 1].sign;
    if (here == before && after == before) continue;
    const RayGroup& g = groups_[group_first_[column] + k];
    RayEvent& event = row.events.emplace_back();
    event.at.exact = g.exact >= 0 ? exacts_[g.exact] : place(sorted_[g.first]);
    event.at.value = g.at;
    event.at.radius = g.error;
    event.here = static_cast<std::int8_t>(sense * here);
    event.after = static_cast<std::int8_t>(sense * after);
    before = after;
  }
  row.first.push_back(static_cast<int>(row.events.size()));
}

}  // namespace findspace::space
