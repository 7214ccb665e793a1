// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/farthest_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "distance/planar/place_search.h"
#include "distance/planar_features/feature_pair_search.h"
#include "exact/number/margins.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

FarthestPlace PlaceSearch::exact_vertex(const Found& f) const {
  RealPoint at = b_.region().geometry.exact(b_.region().vertices[f.cell.index].point);
  at = {at.x + p_.x, at.y + p_.y};
  FeaturePair near = nearest_point(a_, at);
  return {near.distance, at, f.cell, near};
}

/// The vertices and edges of A with a place no farther than `reach` that is the nearest of its line or vertex.
std::vector<BoundaryFeature> PlaceSearch::parts_near(Spot at, double reach) const {
  std::vector<BoundaryFeature> out;
  auto add = [&](const BoundaryFeature& s) {
    auto same = [&](const BoundaryFeature& k) { return k.cell == s.cell; };
    if (s.distance(at.x, at.y) <= reach && std::none_of(out.begin(), out.end(), same)) out.push_back(s);
  };
  a_.for_near(at.x, at.y, reach, [&](plane::Index k) {
    const BoundaryFeature& s = a_.features()[k];
    if (s.faces(at.x, at.y)) add(s);
    if (s.is_vertex()) return true;
    const plane::Edge& e = a_.region().edges[s.cell.index];
    add(vertex_feature(a_.region(), e.v0));
    add(vertex_feature(a_.region(), e.v1));
    return true;
  });
  return out;
}

/// A place of the found cell's line or of the plane, within `tolerance` of what was found, lies on the cell, or in B.
bool PlaceSearch::is_in_b(const Found& f, const RealPoint& at, double tolerance) const {
  const auto& b = b_.region();
  const RealPoint own{at.x - p_.x, at.y - p_.y};
  const double x = near_value(own.x), y = near_value(own.y);
  if (f.cell.dimension == 2) {
    if (auto in = b_.contains(x, y, b_.nearest(x, y))) return *in;
    return mark_of(b, locate(b, own)) > 0;
  }
  const BoundaryFeature edge = edge_feature(b, f.cell.index);
  if (std::min(plain_length(x - edge.x0, y - edge.y0), plain_length(x - edge.x1, y - edge.y1)) > 2 * tolerance)
    return true;
  const RealPoint v = b.geometry.exact(b.vertices[b.edges[f.cell.index].v0].point),
                  w = b.geometry.exact(b.vertices[b.edges[f.cell.index].v1].point);
  auto along = [&](const RealPoint& from, const RealPoint& to) {
    return ((own.x - from.x) * (to.x - from.x) + (own.y - from.y) * (to.y - from.y)).sign();
  };
  return along(v, w) >= 0 && along(w, v) >= 0;
}

namespace {

/// Some of many, spread over the directions in which they lie.
std::vector<BoundaryFeature> spread(std::vector<BoundaryFeature> parts, Spot from) {
  if (parts.size() <= kMostParts) return parts;
  auto direction = [&](const BoundaryFeature& s) {
    const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, size = dx * dx + dy * dy;
    const double t = s.is_vertex() ? 0 : ((from.x - s.x0) * dx + (from.y - s.y0) * dy) / size;
    return std::atan2(s.y0 + t * dy - from.y, s.x0 + t * dx - from.x);
  };
  std::sort(parts.begin(), parts.end(),
            [&](const BoundaryFeature& s, const BoundaryFeature& t) { return direction(s) < direction(t); });
  std::vector<BoundaryFeature> out;
  for (std::size_t k = 0; k < kMostParts; ++k) out.push_back(parts[k * parts.size() / kMostParts]);
  return out;
}

/// The events of the parts of A around a place: of two of them and B's edge, or of three.
template <class Take>
void for_meetings(std::span<const LevelCurve> fronts, const std::optional<LevelCurve>& edge, Take&& take) {
  for (std::size_t i = 0; i < fronts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (edge) take(i, events(fronts[i], fronts[j], *edge));
      for (std::size_t k = 0; !edge && k < j; ++k) take(i, events(fronts[i], fronts[j], fronts[k]));
    }
}

}  // namespace

/// Where two parts of A and the edge meet at one distance, or three parts of A, the farthest of those places that lie
/// in B. What was found itself, where no such place is as far.
std::optional<FarthestPlace> PlaceSearch::exact_meeting(const Found& f) const {
  const double tolerance = std::max(scale_ * margin::kMeetingOff, kMeetingRoom * f.error);
  const Spot at = f.seen.at;
  const auto parts = spread(parts_near(at, f.seen.near.distance + tolerance), at);
  std::vector<LevelCurve> fronts;
  for (const BoundaryFeature& s : parts) fronts.push_back(near_level_curve(a_.region(), s, at.x, at.y, 1));
  std::optional<LevelCurve> edge;
  if (f.cell.dimension == 1)
    edge = still_front(b_.region(), edge_feature(b_.region(), f.cell.index)).moved({-p_.x, -p_.y});
  std::optional<FarthestPlace> best;
  double most = -std::numeric_limits<double>::infinity(), least_error = 0;
  for_meetings(fronts, edge, [&](std::size_t part, const std::vector<Event>& all) {
    for (const Event& e : all) {
      if (!e.at) continue;
      const double x = near_value(e.at->x), y = near_value(e.at->y), level = near_value(e.level);
      if (!(plain_length(x - at.x, y - at.y) <= tolerance)) continue;
      const double error = std::abs(a_.nearest(x, y, f.seen.near.feature).distance - level);
      const bool better = level > most + slack_ || (level > most - slack_ && error < least_error);
      if (error > slack_ * 4 || (best && !better) || !is_in_b(f, *e.at, tolerance)) continue;
      best = FarthestPlace{e.level, *e.at, f.cell, exact_pair(a_.region(), parts[part].cell, *e.at)};
      most = level;
      least_error = error;
    }
  });
  if (most > f.seen.value - 8 * slack_) return best;
  const RealPoint place{Real::from_double(at.x), Real::from_double(at.y)};
  // A place found by a box at B's boundary may lie beyond it; then the edge has its own.
  if (f.cell.dimension == 2 && !is_in_b(f, place, tolerance)) return best;
  FeaturePair near = nearest_point(a_, place);
  FarthestPlace out{near.distance, place, f.cell, near};
  out.open = near_value(near.distance) + 2 * f.error + slack_;
  if (f.cell.dimension == 1) {
    const auto own = exact_pair(b_.region(), f.cell, {place.x - p_.x, place.y - p_.y});
    out.off = near_value(own->distance) + scale_ * margin::kFewRoundings;
  }
  return out;
}

PlanarAnswer FarthestPlace::answer() const {
  const Real most = Real::from_double(open);
  if (off == 0 && !(value < most)) return exact_answer(value, Way::kFeatures);
  return enclosed_answer(value, value - Real::from_double(off), value < most ? most : value);
}

std::optional<FarthestPlace> PlaceSearch::run() {
  if (a_.empty() || b_.empty()) return std::nullopt;
  walk_boundary();
  search_inside();
  std::optional<FarthestPlace> best;
  for (const Found& f : found_) {
    // What lies beside a place within its error counts as found with it.
    if (f.seen.value + 2 * f.error < best_ - slack_) continue;
    auto k = f.cell.dimension == 0 ? exact_vertex(f) : exact_meeting(f);
    if (k && (!best || k->value > best->value)) best = std::move(k);
  }
  if (open_ == 0) return best;
  if (!best) best = exact_vertex({{}, first_});
  best->open = std::max(best->open, open_);
  return best;
}

std::optional<FarthestPlace> farthest_place(const FeatureTree& b, const FeatureTree& a, const MaxMinBoxes& boxes,
                                            const RealPoint& p, double least_value) {
  return PlaceSearch(b, a, boxes, p, least_value).run();
}

}  // namespace findspace::distance
