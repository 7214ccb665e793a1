// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/farthest_place.h"

#include <algorithm>

#include "distance/place_search.h"
#include "distance/site_pairs.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

namespace {

constexpr std::size_t kMostParts = 10;

}  // namespace

FarthestPlace PlaceSearch::exact_vertex(const Found& f) const {
  RealPoint at = b_.region().geometry.exact(b_.region().vertices[f.cell.index].point);
  at = {at.x + p_.x, at.y + p_.y};
  return {nearest_point(a_, at).distance, at, f.cell};
}

/// Where two parts of A and the edge meet at one distance, or three parts of A.
std::optional<FarthestPlace> PlaceSearch::exact_meeting(const Found& f) const {
  double room = std::max(scale_ * kShortPart, 8 * f.error), x = f.seen.at.x, y = f.seen.at.y;
  std::vector<Front> fronts;
  auto add = [&](const Site& s) {
    if (fronts.size() < kMostParts && s.distance(x, y) <= f.seen.near.distance + room)
      fronts.push_back(near_front(a_.region(), s, x, y, 1));
  };
  std::vector<char> known(a_.region().vertices.size(), 0);
  for (const Site& s : a_.sites()) {
    if (s.distance(x, y) > f.seen.near.distance + room) continue;
    if (s.is_vertex()) {
      add(s);
      continue;
    }
    if (s.faces(x, y)) add(s);
    for (plane::Index v : {a_.region().edges[s.cell.index].v0, a_.region().edges[s.cell.index].v1})
      if (!known[v]) known[v] = 1, add(vertex_site(a_.region(), v));
  }
  std::optional<FarthestPlace> best;
  double least_error = std::numeric_limits<double>::infinity();
  auto take = [&](const std::vector<Event>& all) {
    for (const Event& e : all) {
      if (!e.at) continue;
      double u = near_value(e.at->x), v = near_value(e.at->y);
      if (!(plain_length(u - x, v - y) <= room)) continue;
      double error = std::abs(a_.nearest(u, v, f.seen.near.site).distance - near_value(e.level));
      if (error > slack_ * 4 ||
          (best && near_value(e.level) <= near_value(best->value) + slack_ && error >= least_error))
        continue;
      best = FarthestPlace{e.level, *e.at, f.cell};
      least_error = error;
    }
  };
  std::optional<Front> edge;
  if (f.cell.dimension == 1)
    edge = still_front(b_.region(), edge_site(b_.region(), f.cell.index)).moved({-p_.x, -p_.y});
  for (std::size_t i = 0; i < fronts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (edge) take(events(fronts[i], fronts[j], *edge));
      for (std::size_t k = 0; !edge && k < j; ++k) take(events(fronts[i], fronts[j], fronts[k]));
    }
  if (!best) {
    RealPoint at{Real::from_double(x), Real::from_double(y)};
    best = FarthestPlace{nearest_point(a_, at).distance, at, f.cell};
  }
  // A place found by a box at B's boundary may lie beyond it; then the edge has its own.
  const auto& b = b_.region();
  if (f.cell.dimension == 2 && mark_of(b, locate(b, {best->at.x - p_.x, best->at.y - p_.y})) <= 0) return std::nullopt;
  return best;
}

std::optional<FarthestPlace> PlaceSearch::run() {
  if (a_.empty() || b_.empty()) return std::nullopt;
  walk_boundary();
  search_inside();
  std::optional<FarthestPlace> best;
  for (const Found& f : found_) {
    if (f.seen.value + f.error < best_ - slack_) continue;
    auto k = f.cell.dimension == 0 ? exact_vertex(f) : exact_meeting(f);
    if (k && (!best || k->value > best->value)) best = std::move(k);
  }
  return best;
}

std::optional<FarthestPlace> farthest_place(const SiteTree& b, const SiteTree& a, const RealPoint& p,
                                            double least_value) {
  return PlaceSearch(b, a, p, least_value).run();
}

}  // namespace findspace::distance
