// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/offset_meetings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "exact/planar/geometry_signs.h"
#include "plane/base/small_sort.h"
#include "plane/base/union_find.h"
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

void OffsetMeetings::find() {
  PieceMeetings found(c_.geometry, c_.pieces, kHeap);
  for (const auto& [i, j] : near_pairs(c_)) {
    const Index known = Index(c_.geometry.points.size());
    found.add_pair(i, j);
    if (found.splits.empty() && found.ties.empty()) continue;
    note(found, known, i, j);
    found.splits.clear();
    found.ties.clear();
  }
  sort_stops();
}

void OffsetMeetings::note(const PieceMeetings& found, Index known, Index i, Index j) {
  const exact::Geometry& g = c_.geometry;
  for (const PieceMeetings::Tie& tie : found.ties)
    if (!is_inside(tie.p, {i, j})) ties_.push_back(tie);
  for (std::size_t k = 0; k < found.splits.size(); ++k) {
    const auto& [piece, point] = found.splits[k];
    const bool crossing = point >= known &&
                          !touch_at(g, point, c_.pieces[i].supporting_curve, c_.pieces[j].supporting_curve) &&
                          k + 1 < found.splits.size() && found.splits[k + 1].point == point;
    if (crossing) {
      const Index first = Index(stops_.size());
      stops_.push_back({i, point, j, first + 1});
      stops_.push_back({j, point, i, first});
      ++k;
    } else if (!is_inside(point, {i, j})) {
      stops_.push_back({piece, point, kNone, kNone});
      ties_.push_back({point, point});
    }
  }
}

void OffsetMeetings::sort_stops() {
  const Index n = Index(c_.pieces.size());
  first_.assign(n + 1, 0);
  for (const Stop& s : stops_) ++first_[s.piece + 1];
  for (Index i = 0; i < n; ++i) first_[i + 1] += first_[i];
  std::vector<Index> order(stops_.size()), at(first_.begin(), first_.end() - 1);
  for (Index s = 0; s < stops_.size(); ++s) order[at[stops_[s].piece]++] = s;
  for (Index i = 0; i < n; ++i) {
    if (first_[i + 1] - first_[i] < 2) continue;
    const auto along = [&](Index s, Index t) {
      return compare_along(c_.geometry, c_.pieces[i], stops_[s].point, stops_[t].point);
    };
    const std::span<Index> stops = std::span(order).subspan(first_[i], first_[i + 1] - first_[i]);
    small_sort(stops.begin(), stops.end(), [&](Index s, Index t) {
      if (stops_[s].point == stops_[t].point) return false;
      return c_.origins[i].right ? along(s, t) < 0 : along(s, t) > 0;
    });
    tie_equal(i, stops);
  }
  if (!ties_.empty()) number_ties();
  set_stops(order);
}

void OffsetMeetings::tie_equal(Index piece, std::span<const Index> stops) {
  for (std::size_t k = 1; k < stops.size(); ++k) {
    const Stop &s = stops_[stops[k - 1]], &t = stops_[stops[k]];
    if (s.point == t.point || compare_along(c_.geometry, c_.pieces[piece], s.point, t.point) != 0) continue;
    const bool tied = s.other == kNone || t.other == kNone;
    if (tied || !is_inside(s.point, {piece, s.other, t.other})) ties_.push_back({s.point, t.point});
  }
}

void OffsetMeetings::number_ties() {
  UnionFind same(c_.geometry.points.size());
  for (const auto& [p, q] : ties_) same.unite(p, q);
  tie_of_.assign(c_.geometry.points.size(), kNone);
  for (const auto& [p, q] : ties_) {
    const Index root = same.find(p);
    if (tie_of_[root] == kNone) {
      tie_of_[root] = Index(tie_points_.size());
      tie_points_.push_back(root);
    }
    tie_of_[p] = tie_of_[q] = tie_of_[root];
  }
}

void OffsetMeetings::set_stops(const std::vector<Index>& order) {
  std::vector<Stop> sorted;
  sorted.reserve(stops_.size());
  std::vector<Index> place(stops_.size());
  for (Index i = 0; i < c_.pieces.size(); ++i) {
    const Index from = first_[i], first = Index(sorted.size());
    first_[i] = first;
    for (Index k = from; k < first_[i + 1]; ++k) {
      Stop s = stops_[order[k]];
      const Index tie = tie_at(s.point);
      if (tie != kNone) {
        s.other = kNone;
        s.twin = tie;
        if (sorted.size() > first && sorted.back().other == kNone && sorted.back().twin == tie) continue;
      }
      place[order[k]] = Index(sorted.size()) - first;
      sorted.push_back(s);
    }
  }
  first_.back() = Index(sorted.size());
  for (Stop& s : sorted)
    if (s.other != kNone) s.twin = place[s.twin];
  stops_ = std::move(sorted);
}

}  // namespace findspace::plane
