// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_ties.h"

#include <algorithm>
#include <cassert>

#include "plane/base/small_sort.h"
#include "plane/complex/around_vertex.h"

namespace findspace::plane {

OffsetTies::OffsetTies(const OffsetCurves& curves, const OffsetMeetings& meetings) : c_(curves), m_(meetings) {
  if (m_.tie_count() == 0) return;
  collect();
  for (Index t = 0; t < m_.tie_count(); ++t) resolve(ways_.begin() + first_[t], ways_.begin() + first_[t + 1]);
}

void OffsetTies::collect() {
  std::vector<Way> found;
  const auto add = [&](Index point, OffsetPart part, bool starts) {
    if (const Index tie = m_.tie_at(point); tie != kNone) found.push_back({tie, part, starts});
  };
  for (Index i = 0; i < c_.pieces.size(); ++i) {
    const Index stops = m_.stop_count(i);
    for (Index k = 0; k <= stops; ++k) {
      add(k == 0 ? c_.start(i) : m_.stop(i, k - 1).point, {i, k}, true);
      add(k == stops ? c_.end(i) : m_.stop(i, k).point, {i, k}, false);
    }
  }
  first_.assign(m_.tie_count() + 1, 0);
  for (const Way& w : found) ++first_[w.tie + 1];
  for (Index t = 0; t < m_.tie_count(); ++t) first_[t + 1] += first_[t];
  std::vector<Index> at(first_.begin(), first_.end() - 1);
  ways_.resize(found.size());
  for (const Way& w : found) ways_[at[w.tie]++] = w;
}

exact::Heading OffsetTies::heading(const Way& w) const {
  exact::Heading h = c_.heading(w.part.piece);
  if (!w.starts) h.forward = !h.forward;
  return h;
}

bool OffsetTies::same_direction(const Way& v, const Way& w) const {
  const Piece &p = c_.pieces[v.part.piece], &q = c_.pieces[w.part.piece];
  return right(v) == right(w) && p.half == q.half &&
         (p.supporting_curve == q.supporting_curve ||
          same_supporting_curve(c_.geometry.supporting_curves[p.supporting_curve],
                                c_.geometry.supporting_curves[q.supporting_curve]));
}

bool OffsetTies::comes_first(const Way& v, const Way& w) const {
  if (right(v) != right(w)) return right(v);
  if (same_direction(v, w)) return v.part.piece < w.part.piece;
  return comes_before(c_.geometry, m_.tie_point(v.tie), !right(v), heading(v), c_.pieces[v.part.piece].half,
                      heading(w));
}

Index OffsetTies::number_directions(Ways first, Ways last) {
  small_sort(first, last, [&](const Way& v, const Way& w) { return comes_first(v, w); });
  Index directions = 0;
  for (Ways w = first; w != last; ++w) {
    if (w == first || !same_direction(*(w - 1), *w)) ++directions;
    w->direction = directions - 1;
  }
  return directions;
}

OffsetTies::Covered OffsetTies::covered(Ways first, Ways last, Index directions) const {
  Covered c{std::vector<char>(directions, false), std::vector<char>(directions, false)};
  for (Ways in = first; in != last; ++in) {
    if (in->starts) continue;
    const auto [piece, slot] = in->part;
    const OffsetPart on =
        slot < m_.stop_count(piece) ? OffsetPart{piece, slot + 1} : OffsetPart{c_.origins[piece].next, 0};
    const Ways out = std::find_if(
        first, last, [&](const Way& w) { return w.starts && w.part.piece == on.piece && w.part.slot == on.slot; });
    assert(out != last);  // curves end loosely inside D alone
    for (Index k = out->direction; k != in->direction; k = (k + 1) % directions) {
      c.sectors[k] = true;
      if (k != out->direction) c.directions[k] = true;
    }
  }
  return c;
}

void OffsetTies::resolve(Ways first, Ways last) {
  const Index n = number_directions(first, last);
  const Covered covered = this->covered(first, last, n);
  const auto start_at = [&](Index direction) {
    return std::find_if(first, last, [&](const Way& w) { return w.starts && w.direction == direction; });
  };
  bool single = true;
  for (Index d = 0; d < n; ++d) {
    if (!covered.sectors[d]) {
      reach(first, last, d, *start_at((d + 1) % n));
      single = false;
    } else if (!covered.directions[d] && covered.sectors[(d + n - 1) % n]) {
      const Way& out = *start_at(d);
      if (right(out)) slits.push_back(out.part);
      single = false;
    }
  }
  for (Ways w = first; w != last; ++w)
    if (w->starts && !w->reached) not_reached.push_back(w->part);
  if (single) single_points.push_back(m_.tie_point(first->tie));
}

void OffsetTies::reach(Ways first, Ways last, Index direction, Way& out) {
  out.reached = true;
  for (Ways w = first; w != last; ++w)
    if (!w->starts && w->direction == direction) w->after = out.part;
}

OffsetPart OffsetTies::after(Index tie, OffsetPart part) const {
  for (Index k = first_[tie]; k < first_[tie + 1]; ++k) {
    const Way& w = ways_[k];
    if (!w.starts && w.part.piece == part.piece && w.part.slot == part.slot) return w.after;
  }
  return {kNone, kNone};
}

}  // namespace findspace::plane
