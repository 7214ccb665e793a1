// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_row_hits.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"

namespace findspace::space {

using exact::Fraction;

namespace {

RowHit exact_hit(RowHits& row, int column, int sheet, const Fraction& z, int jump, bool touch) {
  const double at = exact::to_double(z);
  row.exacts.push_back(z);
  return {at,   margin::kRoundings8 * (std::fabs(at) + 1), column, sheet, static_cast<int>(row.exacts.size()) - 1, jump,
          touch};
}

void find_sections(RowHits& row) {
  const auto soil = [&](int column) { row.dirty[column] = 1; };
  row.cuts.clear();
  for (const int k : row.sheets.row(row.j)) {
    row.sheets.mark_row_contacts(k, row.j, soil);
    RowCut cut;
    if (!row.sheets.section(k, row.j, cut.section)) continue;
    for (const int column : cut.section.tie) {
      if (column >= 0) soil(column);
    }
    cut.sheet = k;
    row.cuts.push_back(cut);
  }
}

/// A facet parallel to the lines: where this line runs in it, if it does.
void meet_upright(RowHits& row, const Sheet& s, int sheet, int column, std::vector<RowWall>& walls) {
  const std::int64_t x = row.sheets.grid().u_at(column);
  const RayFacet& f = s.facet;
  std::vector<Fraction> ends;
  for (int c = 0; c < f.corners; ++c) {
    const Point &p = f.corner[c], &q = f.corner[c + 1 == f.corners ? 0 : c + 1];
    if (exact::sign_turn(p.x, p.y, q.x, q.y, x, row.y) != 0) continue;
    if (p.x == q.x && p.y == q.y) {
      if (p.x == x && p.y == row.y) ends.insert(ends.end(), {{p.z, 1}, {q.z, 1}});
      continue;
    }
    if (std::min(p.x, q.x) > x || std::max(p.x, q.x) < x || std::min(p.y, q.y) > row.y || std::max(p.y, q.y) < row.y)
      continue;
    const std::int64_t along = p.x != q.x ? q.x - p.x : q.y - p.y, to = p.x != q.x ? x - p.x : row.y - p.y;
    Fraction z{int128(p.z) * along + int128(q.z - p.z) * to, along};
    if (along < 0) z = {-z.numerator, -z.denominator};
    ends.push_back(z);
  }
  if (ends.empty()) return;
  const auto less = [](const Fraction& a, const Fraction& b) { return exact::compare_fractions(a, b) < 0; };
  const auto [low, high] = std::minmax_element(ends.begin(), ends.end(), less);
  for (const Fraction& z : {*low, *high}) row.unordered.push_back(exact_hit(row, column, sheet, z, 0, true));
  if (less(*low, *high)) walls.push_back({*low, *high});
}

/// A line through corners or along edges of facets: every facet whose closed projection holds it, exactly.
void collect_dirty(RowHits& row, int column) {
  const std::int64_t x = row.sheets.grid().u_at(column);
  row.dirty_number[column] = static_cast<int>(row.walls.size());
  std::vector<RowWall>& walls = row.walls.emplace_back();
  for (const int k : row.sheets.row(row.j)) {
    const Sheet& s = row.sheets[k];
    const RayFacet& f = s.facet;
    std::int64_t left = f.corner[0].x, right = left;
    for (int c = 1; c < f.corners; ++c) {
      left = std::min(left, f.corner[c].x);
      right = std::max(right, f.corner[c].x);
    }
    if (x < left || x > right) continue;
    if (s.jump == 0) {
      meet_upright(row, s, k, column, walls);
      continue;
    }
    int sense = 0;
    bool outside = false, edge = false;
    for (int c = 0; c < f.corners && !outside; ++c) {
      const Point &p = f.corner[c], &q = f.corner[c + 1 == f.corners ? 0 : c + 1];
      const int t = exact::sign_turn(p.x, p.y, q.x, q.y, x, row.y);
      edge = edge || t == 0;
      outside = t != 0 && sense != 0 && t != sense;
      if (t != 0) sense = t;
    }
    if (outside) continue;
    const int jump = s.meets_displaced(x, row.y) ? s.jump : 0;
    row.unordered.push_back(exact_hit(row, column, k, s.height_exactly(x, row.y), jump, edge));
  }
}

/// The hits of the lines that pass through the insides of facets only.
void place_hits(RowHits& row) {
  for (const RowCut& c : row.cuts) {
    const Sheet& s = row.sheets[c.sheet];
    if (s.jump == 0) continue;
    const bool rounded = s.slack <= margin::kCoarseHeight;
    for (int i = c.section.column[0]; i < c.section.column[1]; ++i) {
      if (row.dirty[i]) continue;
      const std::int64_t x = row.sheets.grid().u_at(i);
      row.sorted[row.next[i]++] = rounded ? RowHit{s.height(x, row.y), s.slack, i, c.sheet, -1, s.jump, false}
                                          : exact_hit(row, i, c.sheet, s.height_exactly(x, row.y), s.jump, false);
    }
  }
}

void collect(RowHits& row) {
  // Differences from column to column first.
  row.first.assign(row.columns + 1, 0);
  row.next.assign(row.columns + 1, 0);
  for (const RowCut& c : row.cuts) {
    if (row.sheets[c.sheet].jump == 0) continue;
    ++row.next[c.section.column[0]];
    --row.next[c.section.column[1]];
  }
  row.dirty_number.assign(row.columns, -1);
  row.unordered.clear();
  for (int i = 0, met = 0; i < row.columns; ++i) {
    met += row.next[i];
    const std::size_t before = row.unordered.size();
    if (row.dirty[i]) collect_dirty(row, i);
    row.first[i + 1] = row.first[i] + (row.dirty[i] ? static_cast<int>(row.unordered.size() - before) : met);
  }
  row.next.assign(row.first.begin(), row.first.end() - 1);
  row.sorted.resize(row.first.back());
  for (const RowHit& h : row.unordered) row.sorted[row.next[h.column]++] = h;
  place_hits(row);
}

/// By insertion: lines meet few facets, and the doubles nearly always tell. Long ones are put nearly in order before.
void sort_column(RowHits& row, int column) {
  constexpr int kFew = 16;
  const auto begin = row.sorted.begin() + row.first[column], end = row.sorted.begin() + row.first[column + 1];
  if (end - begin > kFew)
    std::sort(begin, end,
              [](const RowHit& a, const RowHit& b) { return a.at != b.at ? a.at < b.at : a.sheet < b.sheet; });
  for (auto h = begin; h != end; ++h) {
    if (h == begin || !comes_before(row, *h, *(h - 1))) continue;
    const RowHit moved = *h;
    auto k = h;
    do {
      *k = *(k - 1);
    } while (--k != begin && comes_before(row, moved, *(k - 1)));
    *k = moved;
  }
}

}  // namespace

Fraction place(const RowHits& hits, const RowHit& h) {
  return h.exact >= 0 ? hits.exacts[h.exact]
                      : hits.sheets[h.sheet].height_exactly(hits.sheets.grid().u_at(h.column), hits.y);
}

void find_hits(RowHits& row, int j) {
  row.j = j;
  row.y = row.sheets.grid().v_at(j);
  row.dirty.assign(row.columns, 0);
  row.exacts.clear();
  row.walls.clear();
  find_sections(row);
  collect(row);
  for (int i = 0; i < row.columns; ++i) sort_column(row, i);
}

}  // namespace findspace::space
