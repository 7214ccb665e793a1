// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/farthest_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "distance/planar/place_search.h"
#include "distance/planar_features/feature_pair_search.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;

namespace {

FarthestPlace exact_vertex(const PlacedSets& sets, const Found& f) {
  RealPoint at = sets.b.region().geometry.exact(sets.b.region().vertices[f.cell.index].point);
  at = {at.x + sets.p.x, at.y + sets.p.y};
  FeaturePair near = nearest_point(sets.a, at);
  return {near.distance, at, f.cell, near};
}

/// A place of the found cell's line or of the plane, within `tolerance` of what was found, lies on the cell, or in B.
bool is_in_b(const PlacedSets& sets, const Found& f, const RealPoint& at, double tolerance) {
  const auto& b = sets.b.region();
  const RealPoint own{at.x - sets.p.x, at.y - sets.p.y};
  const double x = near_value(own.x), y = near_value(own.y);
  if (f.cell.dimension == 2) {
    if (auto in = sets.b.contains(x, y, sets.b.nearest(x, y))) return *in;
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
void for_meetings(std::span<const LevelCurve> level_curves, const std::optional<LevelCurve>& edge, Take&& take) {
  for (std::size_t i = 0; i < level_curves.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (edge) take(i, events(level_curves[i], level_curves[j], *edge));
      for (std::size_t k = 0; !edge && k < j; ++k) take(i, events(level_curves[i], level_curves[j], level_curves[k]));
    }
}

/// The least distance of a place to some parts of A: exact, rounded once.
double least_distance(const PlacedSets& sets, std::span<const BoundaryFeature> parts, const RealPoint& at) {
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryFeature& s : parts)
    if (const auto pair = exact_pair(sets.a.region(), s.cell, at)) least = std::min(least, pair->distance.to_double());
  return least;
}

/// Where two parts of A and the edge meet at one distance, or three parts of A, the farthest of those places that lie
/// in B: by their exact distances rounded once, as roots this deep are too costly to compare. What was found itself,
/// where no such place is as far.
std::optional<FarthestPlace> exact_meeting(const PlacedSets& sets, const Found& f) {
  const double tolerance = std::max(sets.scale * margin::kMeetingOff, margin::kMeetingTolerance * f.error);
  const Spot at = f.seen.at;
  const auto parts = spread(sets.parts_near(at, f.seen.near.distance + tolerance), at);
  std::vector<LevelCurve> level_curves;
  for (const BoundaryFeature& s : parts) level_curves.push_back(near_level_curve(sets.a.region(), s, at.x, at.y, 1));
  std::optional<LevelCurve> edge;
  if (f.cell.dimension == 1)
    edge =
        fixed_level_curve(sets.b.region(), edge_feature(sets.b.region(), f.cell.index)).moved({-sets.p.x, -sets.p.y});
  std::optional<FarthestPlace> best;
  double most = -std::numeric_limits<double>::infinity();
  for_meetings(level_curves, edge, [&](std::size_t part, const std::vector<Event>& all) {
    for (const Event& e : all) {
      if (!e.at) continue;
      const double x = near_value(e.at->x), y = near_value(e.at->y);
      if (!(plain_length(x - at.x, y - at.y) <= tolerance)) continue;
      const double near = sets.a.nearest(x, y, f.seen.near.feature).distance;
      if (std::abs(near - near_value(e.level)) > sets.slack * 4 || near <= most - sets.slack) continue;
      const double level = e.level.to_double();
      // A part that is nearer makes it no meeting of the nearest parts.
      if (level <= most || least_distance(sets, parts, *e.at) < level * margin::kRoundedOnce ||
          !is_in_b(sets, f, *e.at, tolerance))
        continue;
      best = FarthestPlace{e.level, *e.at, f.cell, exact_pair(sets.a.region(), parts[part].cell, *e.at)};
      most = level;
    }
  });
  if (most > f.seen.value - 8 * sets.slack) return best;
  const RealPoint place{Real::from_double(at.x), Real::from_double(at.y)};
  // A place found by a box at B's boundary may lie beyond it; then the edge has its own.
  if (f.cell.dimension == 2 && !is_in_b(sets, f, place, tolerance)) return best;
  FeaturePair near = nearest_point(sets.a, place);
  FarthestPlace out{near.distance, place, f.cell, near};
  out.open = near_value(near.distance) + 2 * f.error + sets.slack;
  if (f.cell.dimension == 1) {
    const RealPoint own{place.x - sets.p.x, place.y - sets.p.y};
    const auto foot = exact_pair(sets.b.region(), f.cell, own);  // nothing where the place is beyond an end of the edge
    const double off = foot
                           ? near_value(foot->distance)
                           : edge_feature(sets.b.region(), f.cell.index).distance(near_value(own.x), near_value(own.y));
    out.off = off + sets.scale * margin::kFewRoundings;
  }
  return out;
}

/// Corners by their exact distances, which have few roots; so others that are closed forms.
bool is_farther(const FarthestPlace& k, const FarthestPlace& than) {
  if (k.cell.dimension == 0 && than.cell.dimension == 0) return k.value > than.value;
  return compare_if_closed(k.value, than.value) > 0;
}

/// Where an edge was halved parts of A may meet. Where they do not, the place is known in numbers only, and gives way
/// to one that is about as far.
bool gives_way(const PlacedSets& sets, const Found& f, const FarthestPlace& k, const FarthestPlace& to) {
  return f.halving && k.open > 0 && near_value(k.value) <= near_value(to.value) + sets.slack;
}

}  // namespace

PlanarAnswer FarthestPlace::answer() const {
  const Real most = Real::from_double(open);
  if (off == 0 && !(value < most)) return exact_answer(value, Way::kFeatures);
  return enclosed_answer(value, value - Real::from_double(off), value < most ? most : value);
}

std::optional<FarthestPlace> farthest_place(const FeatureTree& b, const FeatureTree& a, const MaxMinBoxes& boxes,
                                            const RealPoint& p, double least_value) {
  if (a.empty() || b.empty()) return std::nullopt;
  const PlacedSets sets(b, a, p);
  const FoundPlaces found = PlaceSearch(sets, boxes, least_value).run();
  std::optional<FarthestPlace> best;
  for (const Found& f : found.places) {
    // What lies beside a place within its error counts as found with it.
    if (f.seen.value + 2 * f.error < found.best - sets.slack) continue;
    auto k = f.cell.dimension == 0 ? exact_vertex(sets, f) : exact_meeting(sets, f);
    if (k && (!best || (is_farther(*k, *best) && !gives_way(sets, f, *k, *best)))) best = std::move(k);
  }
  if (found.open == 0) return best;
  if (!best) best = exact_vertex(sets, {{}, found.first});
  best->open = std::max(best->open, found.open);
  return best;
}

}  // namespace findspace::distance
