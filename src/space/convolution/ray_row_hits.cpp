// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the lines of a row meet facets, in order on each, and the cells between. Hits are counted first, so that each
// is written once, where it belongs; lines through corners and along edges are done by themselves, exactly.
#include <algorithm>

#include "exact/number/margins.h"
#include "space/convolution/ray_row.h"

namespace findspace::space {

using exact::Fraction;

void RowWork::find_sections() {
  const auto soil = [&](int column) { dirty_[column] = 1; };
  cuts_.clear();
  for (const int k : sheets_.row(j_)) {
    sheets_.mark_row_contacts(k, j_, soil);
    Cut cut;
    if (!sheets_.section(k, j_, cut.section)) continue;
    for (const int column : cut.section.tie) {
      if (column >= 0) soil(column);
    }
    cut.sheet = k;
    cuts_.push_back(cut);
  }
}

void RowWork::collect() {
  // Differences from column to column first.
  hit_first_.assign(columns_ + 1, 0);
  next_.assign(columns_ + 1, 0);
  for (const Cut& c : cuts_) {
    if (sheets_[c.sheet].jump == 0) continue;
    ++next_[c.section.column[0]];
    --next_[c.section.column[1]];
  }
  dirty_number_.assign(columns_, -1);
  dirty_hits_.clear();
  for (int i = 0, met = 0; i < columns_; ++i) {
    met += next_[i];
    const std::size_t before = dirty_hits_.size();
    if (dirty_[i]) collect_dirty(i);
    hit_first_[i + 1] = hit_first_[i] + (dirty_[i] ? static_cast<int>(dirty_hits_.size() - before) : met);
  }
  pair_.counts_.dirty_lines += static_cast<std::int64_t>(walls_.size());
  next_.assign(hit_first_.begin(), hit_first_.end() - 1);
  sorted_.resize(hit_first_.back());
  for (const Hit& h : dirty_hits_) sorted_[next_[h.column]++] = h;
  place_hits();
}

/// The hits of the lines that pass through the insides of facets only.
void RowWork::place_hits() {
  for (const Cut& c : cuts_) {
    const Sheet& s = sheets_[c.sheet];
    if (s.jump == 0) continue;
    const bool rounded = s.slack <= margin::kCoarseHeight;
    for (int i = c.section.column[0]; i < c.section.column[1]; ++i) {
      if (dirty_[i]) continue;
      const std::int64_t x = sheets_.grid().u_at(i);
      sorted_[next_[i]++] = rounded ? Hit{s.height(x, y_), s.slack, i, c.sheet, -1, s.jump, false}
                                    : exact_hit(i, c.sheet, s.height_exactly(x, y_), s.jump, false);
    }
  }
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
    dirty_hits_.push_back(exact_hit(column, k, s.height_exactly(x, y_), jump, edge));
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
  for (const Fraction& z : {*low, *high}) dirty_hits_.push_back(exact_hit(column, sheet, z, 0, true));
  if (less(*low, *high)) walls.push_back({*low, *high});
}

/// By insertion: lines meet few facets, and the doubles nearly always tell. Long ones are put nearly in order before.
void RowWork::sort_column(int column) {
  constexpr int kFew = 16;
  const auto begin = sorted_.begin() + hit_first_[column], end = sorted_.begin() + hit_first_[column + 1];
  if (end - begin > kFew)
    std::sort(begin, end, [](const Hit& a, const Hit& b) { return a.at != b.at ? a.at < b.at : a.sheet < b.sheet; });
  for (auto h = begin; h != end; ++h) {
    if (h == begin || !comes_before(*h, *(h - 1))) continue;
    const Hit moved = *h;
    auto k = h;
    do {
      *k = *(k - 1);
    } while (--k != begin && comes_before(moved, *(k - 1)));
    *k = moved;
  }
}

void RowWork::group_column(int column) {
  const Hit *hit = sorted_.data() + hit_first_[column], *end = sorted_.data() + hit_first_[column + 1];
  RayGroup* group = groups_.data() + group_first_[column];
  RayCell* cell = cells_.data() + cells_of(column);
  int winding = pair_.base_winding_;
  bool open = false;
  *cell = {winding, false, 2};
  while (hit != end) {
    const Hit* first = hit;
    do {
      winding += hit++->jump;
    } while (hit != end && coincide(*(hit - 1), *hit));
    *group++ = {first->at, first->error, static_cast<int>(first - sorted_.data()), static_cast<int>(hit - first), -1};
    *++cell = {winding, false, static_cast<std::int8_t>(winding != 0 ? -1 : 2)};
    open = open || (winding == 0 && hit != end);
  }
  open_[column] = open;
  group_first_.push_back(static_cast<int>(group - groups_.data()));
}

void RowWork::mark_walls(int column, const std::vector<Wall>& walls) {
  const int count = groups_of(column);
  for (const Wall& w : walls) {
    for (int k = 0; k + 1 < count; ++k) {
      if (exact::compare_fractions(w.from, place(column, k)) <= 0 &&
          exact::compare_fractions(place(column, k + 1), w.to) <= 0) {
        cells_[cells_of(column) + k + 1].wall = true;
        cells_[cells_of(column) + k + 1].sign = 2;
      }
    }
  }
}

}  // namespace findspace::space
