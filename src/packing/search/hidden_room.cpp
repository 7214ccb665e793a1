// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/search/hidden_room.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace findspace::packing {

std::optional<Pose> HiddenRoom::find(const Arrangement& arrangement, std::size_t item) {
  const std::vector<Variant>& variants = arrangement.table().variants();
  const Variant& now = variants[arrangement.pose(item).variant];
  double end = arrangement.pose(item).at.x + now.low.x;
  std::optional<Pose> best;
  for (const std::size_t v : arrangement.table().variants_of(now.part))
    for (const Room<Vec>& room : row_.rooms().all()) {
      Range range{room.low - variants[v].low, room.high - variants[v].high};
      range.high.x = std::min(range.high.x, std::min(arrangement.length(), end) - variants[v].high.x);
      if (range.low.x > range.high.x || range.low.y > range.high.y) continue;
      if (const auto at = rearmost(arrangement, item, v, range)) {
        best = Pose{v, *at};
        end = at->x + variants[v].high.x;
      }
    }
  return best;
}

std::optional<Vec> HiddenRoom::rearmost(const Arrangement& arrangement, std::size_t item, std::size_t variant,
                                        const Range& range) {
  sides_.clear();
  places_.assign({range.low, {range.low.x, range.high.y}});
  for (std::size_t j = 0; j < arrangement.size(); ++j)
    if (j != item) add_sides(arrangement.table(), variant, arrangement.pose(j), range);
  for (const Pose& obstacle : row_.obstacles()) add_sides(arrangement.table(), variant, obstacle, range);
  add_crossings(range);
  std::sort(places_.begin(), places_.end(), [](Vec p, Vec q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  constexpr double kNothing = std::numeric_limits<double>::min();
  const auto free = [&](Vec at) { return arrangement.cost(item, {variant, at}, kNothing) < kNothing; };
  const auto found = std::find_if(places_.begin(), places_.end(), free);
  return found == places_.end() ? std::nullopt : std::optional(*found);
}

/// Those that may reach into the range, with their corners there and where they cross its sides.
void HiddenRoom::add_sides(const FieldTable& table, std::size_t variant, const Pose& other, const Range& range) {
  const FieldTable::Link& link = table.link(other.variant, variant);
  const Vec shift = link.in_field({});
  for (const NoFitEdge& edge : link.field().polygon().edges) {
    Vec p = other.at + link.rotated(edge.from - shift), q = other.at + link.rotated(edge.to - shift);
    offer(range, p);
    if (edge.slit) offer(range, q);
    if (q.x < p.x) std::swap(p, q);
    if (q.x < range.low.x || p.x > range.high.x) continue;
    if (std::max(p.y, q.y) < range.low.y || std::min(p.y, q.y) > range.high.y) continue;
    sides_.push_back({p, q});
    for (const double y : {range.low.y, range.high.y})
      if ((p.y < y) != (q.y < y)) offer(range, {p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)), y});
    if (p.x < range.low.x) offer(range, {range.low.x, p.y + (q.y - p.y) * ((range.low.x - p.x) / (q.x - p.x))});
  }
}

void HiddenRoom::add_crossings(const Range& range) {
  std::sort(sides_.begin(), sides_.end(), [](const Side& s, const Side& t) { return s.from.x < t.from.x; });
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& s = sides_[i];
    const Vec way = s.to - s.from;
    for (std::size_t j = i + 1; j < sides_.size() && sides_[j].from.x <= s.to.x; ++j) {
      const Side& t = sides_[j];
      ++looked_at_;
      const double from = cross(way, t.from - s.from), to = cross(way, t.to - s.from);
      if ((from < 0) == (to < 0)) continue;
      const Vec other = t.to - t.from;
      if ((cross(other, s.from - t.from) < 0) == (cross(other, s.to - t.from) < 0)) continue;
      offer(range, t.from + (from / (from - to)) * other);
    }
  }
}

}  // namespace findspace::packing
