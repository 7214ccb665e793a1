// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_meetings.h"

#include <algorithm>

#include "exact/planar/geometry_signs.h"
#include "plane/base/small_sort.h"
#include "plane/offset/near_pairs.h"

namespace findspace::plane {

bool OffsetMeetings::is_inside(Index point, std::initializer_list<Index> pieces) {
  std::array<Index, 8> own;
  std::size_t n = 0;
  for (Index i : pieces) {
    const OffsetOrigin& t = c_.origins[i];
    own[n++] = t.corner;
    if (t.arc) own[n++] = edges_.before(t.corner);
  }
  return edges_.holds(c_.geometry, point, std::span(own.data(), n));
}

bool OffsetMeetings::find() {
  PieceMeetings found(c_.geometry, c_.pieces, kHeap);
  for (const auto& [i, j] : near_pairs(c_)) {
    const Index known = Index(c_.geometry.points.size());
    found.add_pair(i, j);
    if (found.splits.empty() && found.ties.empty()) continue;
    note(found, known, i, j);
    if (!good_) return false;
    found.splits.clear();
    found.ties.clear();
  }
  return sort_stops();
}

void OffsetMeetings::note(const PieceMeetings& found, Index known, Index i, Index j) {
  const exact::Geometry& g = c_.geometry;
  if (same_supporting_curve(g.supporting_curves[c_.pieces[i].supporting_curve],
                            g.supporting_curves[c_.pieces[j].supporting_curve]))
    good_ = false;
  for (const PieceMeetings::Tie& tie : found.ties) give_up_unless_inside(tie.p, i, j);
  for (std::size_t k = 0; k < found.splits.size(); ++k) {
    const Index point = found.splits[k].point;
    const bool crossing = point >= known &&
                          !touch_at(g, point, c_.pieces[i].supporting_curve, c_.pieces[j].supporting_curve) &&
                          k + 1 < found.splits.size() && found.splits[k + 1].point == point;
    if (!crossing) {
      give_up_unless_inside(point, i, j);
      continue;
    }
    const Index first = Index(stops_.size());
    stops_.push_back({i, point, j, first + 1});
    stops_.push_back({j, point, i, first});
    ++k;
  }
}

bool OffsetMeetings::sort_stops() {
  const Index n = Index(c_.pieces.size());
  first_.assign(n + 1, 0);
  for (const Stop& s : stops_) ++first_[s.piece + 1];
  for (Index i = 0; i < n; ++i) first_[i + 1] += first_[i];
  std::vector<Index> order(stops_.size()), at(first_.begin(), first_.end() - 1), place(stops_.size());
  for (Index s = 0; s < stops_.size(); ++s) order[at[stops_[s].piece]++] = s;
  for (Index i = 0; i < n; ++i) {
    if (first_[i] == first_[i + 1]) continue;
    const auto along = [&](Index s, Index t) {
      return s == t ? 0 : compare_along(c_.geometry, c_.pieces[i], stops_[s].point, stops_[t].point);
    };
    const auto from = order.begin() + first_[i], to = order.begin() + first_[i + 1];
    small_sort(from, to, [&](Index s, Index t) { return c_.origins[i].right ? along(s, t) < 0 : along(s, t) > 0; });
    for (auto k = from; k != to && k + 1 != to; ++k)
      if (along(*k, *(k + 1)) == 0 && !is_inside(stops_[*k].point, {i, stops_[*k].other, stops_[*(k + 1)].other}))
        return false;
    for (auto k = from; k != to; ++k) place[*k] = Index(k - from);
  }
  std::vector<Stop> sorted;
  sorted.reserve(stops_.size());
  for (Index s : order) {
    sorted.push_back(stops_[s]);
    sorted.back().twin = place[stops_[s].twin];
  }
  stops_ = std::move(sorted);
  return true;
}

}  // namespace findspace::plane
