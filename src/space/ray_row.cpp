// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/ray_row.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace findspace::space {

using exact::Fraction;

RowWork::RowWork(const PairRays& pair) : pair_(pair), sheets_(*pair.sheets_), columns_(pair.grid().nu) {}

RayRow RowWork::run(int j) {
  j_ = j, y_ = sheets_.grid().v_at(j);
  dirty_.assign(columns_, 0);
  hits_.clear();
  exacts_.clear();
  walls_.clear();
  groups_.clear();
  cells_.clear();
  collect();
  sort_columns();
  group_first_.assign(1, 0);
  for (int i = 0; i < columns_; ++i) {
    group_column(i);
    group_first_.push_back(static_cast<int>(groups_.size()));
    if (dirty_[i]) mark_walls(i, walls_[dirty_number_[i]]);
  }
  settle_cells();
  RayRow row;
  row.before.reserve(columns_);
  row.first.reserve(columns_ + 1);
  row.events.reserve(groups_.size());
  for (int i = 0; i < columns_; ++i) emit(i, row);
  pair_.counts_.hits += static_cast<std::int64_t>(hits_.size());
  return row;
}

void RowWork::collect() {
  const auto soil = [&](int column) { dirty_[column] = 1; };
  for (const int k : sheets_.row(j_)) {
    sheets_.mark_row_contacts(k, j_, soil);
    Section section;
    if (!sheets_.section(k, j_, section)) continue;
    for (const int column : section.tie) {
      if (column >= 0) soil(column);
    }
    const Sheet& s = sheets_[k];
    if (s.jump == 0) continue;
    for (int i = section.column[0]; i < section.column[1]; ++i) {
      const std::int64_t x = sheets_.grid().u_at(i);
      const bool rounded = s.slack <= kCoarseSlack;
      hits_.push_back(rounded ? Hit{s.height(x, y_), s.slack, i, k, -1, s.jump, false}
                              : exact_hit(i, k, s.height_exactly(x, y_), s.jump, false));
    }
  }
  dirty_number_.assign(columns_, -1);
  if (std::find(dirty_.begin(), dirty_.end(), 1) == dirty_.end()) return;
  std::erase_if(hits_, [&](const Hit& h) { return dirty_[h.column] != 0; });
  for (int i = 0; i < columns_; ++i) {
    if (dirty_[i]) collect_dirty(i);
  }
  pair_.counts_.dirty_lines += static_cast<std::int64_t>(walls_.size());
}

/// A line through corners or along edges of facets: every facet whose closed projection holds it, exactly.
void RowWork::collect_dirty(int column) {
  const std::int64_t x = sheets_.grid().u_at(column);
  dirty_number_[column] = static_cast<int>(walls_.size());
  std::vector<Wall>& walls = walls_.emplace_back();
  for (const int k : sheets_.row(j_)) {
    const Sheet& s = sheets_[k];
    const RayFacet& f = s.facet;
    std::int64_t left = f.corner[0].x, right = left;
    for (int c = 1; c < f.corners; ++c) {
      left = std::min(left, f.corner[c].x);
      right = std::max(right, f.corner[c].x);
    }
    if (x < left || x > right) continue;
    if (s.jump == 0) {
      meet_upright(s, k, column, walls);
      continue;
    }
    int sense = 0;
    bool outside = false, edge = false;
    for (int c = 0; c < f.corners && !outside; ++c) {
      const Point &p = f.corner[c], &q = f.corner[c + 1 == f.corners ? 0 : c + 1];
      const int t = exact::sign_turn(p.x, p.y, q.x, q.y, x, y_);
      edge = edge || t == 0;
      outside = t != 0 && sense != 0 && t != sense;
      if (t != 0) sense = t;
    }
    if (outside) continue;
    const int jump = s.meets_displaced(x, y_) ? s.jump : 0;
    hits_.push_back(exact_hit(column, k, s.height_exactly(x, y_), jump, edge));
  }
}

/// A facet parallel to the lines: where this line runs in it, if it does.
void RowWork::meet_upright(const Sheet& s, int sheet, int column, std::vector<Wall>& walls) {
  const std::int64_t x = sheets_.grid().u_at(column);
  const RayFacet& f = s.facet;
  std::vector<Fraction> ends;
  for (int c = 0; c < f.corners; ++c) {
    const Point &p = f.corner[c], &q = f.corner[c + 1 == f.corners ? 0 : c + 1];
    if (exact::sign_turn(p.x, p.y, q.x, q.y, x, y_) != 0) continue;
    if (p.x == q.x && p.y == q.y) {
      if (p.x == x && p.y == y_) ends.insert(ends.end(), {{p.z, 1}, {q.z, 1}});
      continue;
    }
    if (std::min(p.x, q.x) > x || std::max(p.x, q.x) < x || std::min(p.y, q.y) > y_ || std::max(p.y, q.y) < y_)
      continue;
    const std::int64_t along = p.x != q.x ? q.x - p.x : q.y - p.y, to = p.x != q.x ? x - p.x : y_ - p.y;
    Fraction z{int128(p.z) * along + int128(q.z - p.z) * to, along};
    if (along < 0) z = {-z.numerator, -z.denominator};
    ends.push_back(z);
  }
  if (ends.empty()) return;
  const auto less = [](const Fraction& a, const Fraction& b) { return exact::compare_fractions(a, b) < 0; };
  const auto [low, high] = std::minmax_element(ends.begin(), ends.end(), less);
  for (const Fraction& z : {*low, *high}) hits_.push_back(exact_hit(column, sheet, z, 0, true));
  if (less(*low, *high)) walls.push_back({*low, *high});
}

RowWork::Hit RowWork::exact_hit(int column, int sheet, const Fraction& z, int jump, bool touch) {
  const double at = exact::to_double(z);
  exacts_.push_back(z);
  return {at,    0x1p-50 * (std::fabs(at) + 1),        column,
          sheet, static_cast<int>(exacts_.size()) - 1, static_cast<std::int8_t>(jump),
          touch};
}

Fraction RowWork::place(const Hit& h) const {
  return h.exact >= 0 ? exacts_[h.exact] : sheets_[h.sheet].height_exactly(sheets_.grid().u_at(h.column), y_);
}

bool RowWork::comes_before(const Hit& a, const Hit& b) const {
  if (a.at + a.error < b.at - b.error) return true;
  if (b.at + b.error < a.at - a.error) return false;
  return exact::compare_fractions(place(a), place(b)) < 0;
}

bool RowWork::coincide(const Hit& a, const Hit& b) const {
  if (a.at + a.error < b.at - b.error || b.at + b.error < a.at - a.error) return false;
  return exact::compare_fractions(place(a), place(b)) == 0;
}

void RowWork::sort_columns() {
  hit_first_.assign(columns_ + 1, 0);
  for (const Hit& h : hits_) ++hit_first_[h.column + 1];
  for (int i = 0; i < columns_; ++i) hit_first_[i + 1] += hit_first_[i];
  std::vector<int> next(hit_first_.begin(), hit_first_.end() - 1);
  sorted_.resize(hits_.size());
  for (const Hit& h : hits_) sorted_[next[h.column]++] = h;
  for (int i = 0; i < columns_; ++i) {
    const auto begin = sorted_.begin() + hit_first_[i], end = sorted_.begin() + hit_first_[i + 1];
    std::sort(begin, end, [](const Hit& a, const Hit& b) { return a.at != b.at ? a.at < b.at : a.sheet < b.sheet; });
    // Nearly in order: what the doubles could not tell is put right exactly.
    for (auto h = begin; h != end; ++h) {
      for (auto k = h; k != begin && comes_before(*k, *(k - 1)); --k) std::swap(*k, *(k - 1));
    }
  }
}

void RowWork::group_column(int column) {
  int winding = pair_.base_winding_;
  cells_.push_back({winding, false, 2});
  for (int h = hit_first_[column]; h < hit_first_[column + 1];) {
    RayGroup group{sorted_[h].at, sorted_[h].error, h, 0, -1};
    do {
      winding += sorted_[h].jump;
      ++group.count;
      ++h;
    } while (h < hit_first_[column + 1] && coincide(sorted_[h - 1], sorted_[h]));
    groups_.push_back(group);
    cells_.push_back({winding, false, 2});
  }
}

Fraction RowWork::place(int column, int group) {
  RayGroup& g = groups_[group_first_[column] + group];
  if (g.exact < 0) {
    exacts_.push_back(place(sorted_[g.first]));
    g.exact = static_cast<int>(exacts_.size()) - 1;
  }
  return exacts_[g.exact];
}

void RowWork::mark_walls(int column, const std::vector<Wall>& walls) {
  const int count = group_first_[column + 1] - group_first_[column], cells = group_first_[column] + column;
  for (const Wall& w : walls) {
    for (int k = 0; k + 1 < count; ++k) {
      if (exact::compare_fractions(w.from, place(column, k)) <= 0 &&
          exact::compare_fractions(place(column, k + 1), w.to) <= 0) {
        cells_[cells + k + 1].wall = true;
      }
    }
  }
}

/// Of a solid by itself all that is asked lies outside or on its surface.
bool RowWork::meets(int column, const Fraction& z) {
  return pair_.overlap_ && pair_.overlap_->interiors_meet(ray_place(sheets_.grid().u_at(column), y_, z), recent_);
}

/// On a facet, so touching at least. Beside a place that is not in the open set U it is not in U either.
std::int8_t RowWork::sign_here(int column, int group) {
  const int cell = group_first_[column] + column + group;
  if (cells_[cell].sign != -1 || cells_[cell + 1].sign != -1) return 0;
  const RayGroup& g = groups_[group_first_[column] + group];
  if (g.count == 1 && !sorted_[g.first].touch) return -1;  // one sheet: what overlaps on one side goes on
  // Where everything overlapping before would come apart here, the sheets that are left upward take all of the winding.
  int left = cells_[cell].winding;
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
  const int cells = group_first_[column] + column, count = group_first_[column + 1] - group_first_[column];
  const int sense = pair_.complement_ ? -1 : 1;
  std::int8_t before = cells_[cells].sign;
  row.before.push_back(static_cast<std::int8_t>(sense * before));
  for (int k = 0; k < count; ++k) {
    const std::int8_t here = sign_here(column, k), after = cells_[cells + k + 1].sign;
    if (here == before && after == before) continue;
    RayEvent event;
    const RayGroup& g = groups_[group_first_[column] + k];
    event.at.exact = g.exact >= 0 ? exacts_[g.exact] : place(sorted_[g.first]);
    event.at.value = g.at;
    event.at.radius = g.error;
    event.here = static_cast<std::int8_t>(sense * here);
    event.after = static_cast<std::int8_t>(sense * after);
    row.events.push_back(std::move(event));
    before = after;
  }
  row.first.push_back(static_cast<int>(row.events.size()));
}

}  // namespace findspace::space
