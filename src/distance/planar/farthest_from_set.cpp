// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/farthest_from_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "distance/planar/max_min_search.h"
#include "distance/planar_features/curved_level_curve.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/real_vector.h"
#include "plane/query/nearest.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Index;
using plane::Mark;
using plane::Region;

using plane::operator+;
using plane::operator-;

namespace {

constexpr long kMostRanges = 100000;
constexpr MaxMinEffort kCoarse{margin::kMaxMinGuess, kMostRanges}, kFine{margin::kMaxMinFine, kMostRanges};

bool inside(Mark m) { return m > 0; }

/// Whether the level can be the max-min value. That of a place on an edge may still grow beside it, but not fall.
/// Other level curves meet there, too: the ridge between two lines goes on past the end of an edge, at levels less than
/// the max-min place's.
bool is_value(const Real& level, const MaxMinPlace& max_min, double scale) {
  const auto i = level.interval();
  if (i.hi < max_min.value - scale * margin::kSurelyLess) return false;
  return max_min.cell.dimension == 1 || i.lo <= max_min.value + scale * margin::kRoundedPlace;
}

/// In p: where the edge's greatest distance from the inside of a circle of A is `level`: its least distance to the
/// centre is r - level.
std::vector<LevelCurve> hollow_level_curves(const LevelCurve& edge, const LevelCurve& circle) {
  if (edge.circle) {
    Real x = circle.a - edge.a, y = circle.b - edge.b;
    return {LevelCurve::ring(x, y, circle.c + edge.c, circle.k), LevelCurve::ring(x, y, edge.c - circle.c, -circle.k)};
  }
  Real n = sqrt(edge.a * edge.a + edge.b * edge.b), c = edge.a * circle.a + edge.b * circle.b - edge.c;
  return {LevelCurve::line(edge.a, edge.b, c - n * circle.c, -n * circle.k),
          LevelCurve::line(edge.a, edge.b, c + n * circle.c, n * circle.k)};
}

}  // namespace

FarthestFromSet::FarthestFromSet(const Region& b, const Region& a)
    : b_(b), a_(a), a_features_(features(a, inside)), b_features_(features(b, inside)), a_reach_(a, a_features_) {
  for (const auto* list : {&a_features_, &b_features_})
    for (const BoundaryFeature& s : *list)
      scale_ = std::max({scale_, std::abs(s.x0), std::abs(s.y0), std::abs(s.x1), std::abs(s.y1), std::abs(s.r)});
}

std::vector<Index> FarthestFromSet::near_features(double x, double y, double tolerance) const {
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryFeature& s : a_features_) least = std::min(least, s.distance(x, y));
  std::vector<Index> out;
  for (Index k = 0; k < a_features_.size(); ++k)
    if (a_features_[k].distance(x, y) <= least + tolerance) out.push_back(k);
  return out;
}

double FarthestFromSet::scale(double px, double py) const { return scale_ + std::abs(px) + std::abs(py); }

/// One for each place, the first ones.
std::vector<MaxMinPlace> FarthestFromSet::distinct(const std::vector<MaxMinPlace>& all, double scale) {
  std::vector<MaxMinPlace> out;
  for (const MaxMinPlace& k : all) {
    const auto known = std::find_if(out.begin(), out.end(), [&](const MaxMinPlace& u) {
      return u.cell == k.cell && std::hypot(u.x - k.x, u.y - k.y) <= scale * margin::kSamePlace;
    });
    if (known != out.end())
      known->unnamed = known->unnamed || k.unnamed;
    else if (out.size() < kMostMaxMins)
      out.push_back(k);
  }
  return out;
}

std::vector<MaxMinPlace> FarthestFromSet::max_mins(double px, double py, double tolerance, double least_value,
                                                   const MaxMinEffort& effort) const {
  double scale = this->scale(px, py);
  const MaxMinSets sets{a_, b_, a_features_, b_features_, a_reach_};
  return distinct(MaxMinSearch(sets, px, py, {scale, tolerance, least_value, effort}).run(), scale);
}

std::optional<FarthestPlace> FarthestFromSet::greatest(const RealPoint& p, double least_value) const {
  const double px = near_value(p.x), py = near_value(p.y), scale = this->scale(px, py);
  std::optional<FarthestPlace> best;
  double unnamed = -std::numeric_limits<double>::infinity();  // so far a place may be that no formula gives
  auto take = [&](const std::vector<MaxMinPlace>& all, double short_part) {
    for (const MaxMinPlace& k : distinct(all, scale)) {
      FarthestPlace place = exact_place(k, p);
      if (k.unnamed) unnamed = std::max(unnamed, k.value + scale * short_part);
      if (!best || compare_if_closed(place.value, best->value) > 0) best = std::move(place);
    }
  };
  MaxMinSearch search({a_, b_, a_features_, b_features_, a_reach_}, px, py,
                      {scale, scale * margin::kSamePlace, least_value, kCoarse});
  take(search.run(), kCoarse.short_part);
  // Where an arc crosses a parabola no formula gives the place, and what was taken for it is less than the greatest.
  // Only what is more is looked for; all that is about as far would be too much where a ridge touches an edge.
  const double more_than = best ? near_value(best->value) + scale * margin::kNothingMore : least_value;
  take(search.finer({scale, scale * margin::kRoundedPlace, more_than, kFine}), kFine.short_part);
  if (!best && search.open() > least_value) best = exact_place({0, 0, 0, {0, 0}}, p);
  if (!best) return best;
  const double value = near_value(best->value);
  best->open = std::max(best->open, search.open());
  if (unnamed >= value) best->open = std::max(best->open, value + scale * 2 * margin::kMaxMinFine);
  return best;
}

/// The event's level is about the distance to A there, not only to some of its parts.
bool FarthestFromSet::is_distance(const Event& e) const {
  double x = near_value(e.at->x), y = near_value(e.at->y), least = std::numeric_limits<double>::infinity();
  for (const BoundaryFeature& s : a_features_) least = std::min(least, s.distance(x, y));
  return std::abs(near_value(e.level) - least) <= (scale_ + std::abs(x) + std::abs(y)) * margin::kRoundedPlace;
}

/// The places near a found one where parts of A are equally far, on the edge of B if it is on one, the farthest first.
std::vector<FarthestFromSet::Meeting> FarthestFromSet::meetings(const MaxMinPlace& max_min, const RealPoint& p) const {
  const double px = near_value(p.x), py = near_value(p.y);
  const double scale = std::max(this->scale(px, py), scale_ + std::abs(max_min.x) + std::abs(max_min.y));
  std::vector<Index> near = near_features(max_min.x, max_min.y, scale * margin::kSamePlace);
  near.resize(std::min(near.size(), kMostMaxMins));
  std::vector<LevelCurve> level_curves;
  for (Index k : near) level_curves.push_back(near_level_curve(a_, a_features_[k], max_min.x, max_min.y, 1));
  std::optional<LevelCurve> edge;
  std::optional<BoundaryFeature> edge_part;
  if (max_min.cell.dimension == 1) {
    edge_part = edge_feature(b_, max_min.cell.index);
    edge = fixed_level_curve(b_, *edge_part).moved({-p.x, -p.y});
  }
  std::vector<Meeting> out;
  auto take = [&](const std::vector<Index>& parts, const std::vector<Event>& all) {
    for (const Event& e : all) {
      if (!e.at || !is_value(e.level, max_min, scale)) continue;
      double x = near_value(e.at->x), y = near_value(e.at->y);
      if (!(std::hypot(x - max_min.x, y - max_min.y) <= scale * margin::kSamePlace) || !is_distance(e)) continue;
      if (edge_part && !(edge_part->distance(x - px, y - py) <= scale * margin::kRoundedPlace)) continue;
      out.push_back({e.level, *e.at, parts});
    }
  };
  for (std::size_t i = 0; i < level_curves.size(); ++i) {
    if (!edge) take({near[i]}, events(level_curves[i]));
    if (edge && (edge->circle || level_curves[i].circle)) take({near[i]}, events(level_curves[i], *edge));
    for (std::size_t j = 0; j < i; ++j) {
      if (edge) take({near[i], near[j]}, events(level_curves[i], level_curves[j], *edge));
      if (!edge && (level_curves[i].circle || level_curves[j].circle))
        take({near[i], near[j]}, events(level_curves[i], level_curves[j]));
      for (std::size_t k = 0; !edge && k < j; ++k)
        take({near[i], near[j], near[k]}, events(level_curves[i], level_curves[j], level_curves[k]));
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Meeting& s, const Meeting& t) { return near_value(s.level) > near_value(t.level); });
  return out;
}

/// The place is one of B + p, exactly: of its edge's line or circle it is one already.
bool FarthestFromSet::is_in_b(const MaxMinPlace& max_min, const RealPoint& own) const {
  if (max_min.cell.dimension == 1) {
    const BoundaryFeature edge = edge_feature(b_, max_min.cell.index);
    const double x = near_value(own.x), y = near_value(own.y), near = scale(x, y) * margin::kRoundedPlace;
    const double to_ends = std::min(plain_length(x - edge.x0, y - edge.y0), plain_length(x - edge.x1, y - edge.y1));
    if (to_ends > near && edge.faces(x, y)) return true;
  }
  return inside(mark_of(b_, locate(b_, own)));
}

/// The level is the distance to A, exactly. It is where no other part of A is about as near.
bool FarthestFromSet::is_exact(const Meeting& m) const {
  const double x = near_value(m.at.x), y = near_value(m.at.y), level = near_value(m.level);
  const double near = (scale_ + std::abs(x) + std::abs(y)) * margin::kRoundedPlace;
  const bool alone = [&] {
    for (Index k = 0; k < a_features_.size(); ++k) {
      if (a_features_[k].distance(x, y) > level + near) continue;
      if (std::find(m.parts.begin(), m.parts.end(), k) == m.parts.end()) return false;
    }
    return true;
  }();
  return alone || plane::nearest(a_, inside, m.at)->distance == m.level;
}

FarthestPlace FarthestFromSet::exact_place(const MaxMinPlace& max_min, const RealPoint& p) const {
  if (max_min.cell.dimension == 0) {
    RealPoint at = b_.geometry.exact(b_.vertices[max_min.cell.index].point) + p;
    return {plane::nearest(a_, inside, at)->distance, at, max_min.cell};
  }
  for (const Meeting& m : meetings(max_min, p))
    if (is_in_b(max_min, m.at - p) && is_exact(m)) return {m.level, m.at, max_min.cell};
  const RealPoint at{Real::from_double(max_min.x), Real::from_double(max_min.y)}, own = at - p;
  FarthestPlace out{plane::nearest(a_, inside, at)->distance, at, max_min.cell};
  const double scale = this->scale(near_value(p.x), near_value(p.y));
  if (!inside(mark_of(b_, locate(b_, own))))
    out.off = near_value(plane::nearest(b_, inside, own)->distance) + scale * margin::kFewRoundings;
  out.open = near_value(out.value) + scale * 2 * margin::kMaxMinFine;
  return out;
}

void FarthestFromSet::add_level_curves(const MaxMinPlace& max_min, const RealPoint& p, double tolerance,
                                       std::vector<NearLevelCurve>& out) const {
  const double px = near_value(p.x), py = near_value(p.y);
  auto put = [&](const LevelCurve& f) { out.push_back({f, f.gap(px, py, max_min.value)}); };
  if (max_min.cell.dimension == 2) return put(LevelCurve::ring(Real(), Real(), -exact_place(max_min, p).value, 1));
  std::vector<LevelCurve> level_curves;
  for (Index k : near_features(max_min.x, max_min.y, tolerance))
    level_curves.push_back(near_level_curve(a_, a_features_[k], max_min.x, max_min.y, 1));
  if (max_min.cell.dimension == 0) {
    RealPoint b = b_.geometry.exact(b_.vertices[max_min.cell.index].point);
    for (const LevelCurve& f : level_curves) put(f.moved(b));
    return;
  }
  LevelCurve edge = fixed_level_curve(b_, edge_feature(b_, max_min.cell.index));
  for (std::size_t i = 0; i < level_curves.size(); ++i) {
    if (level_curves[i].circle && level_curves[i].k.sign() < 0)
      for (const LevelCurve& f : hollow_level_curves(edge, level_curves[i])) put(f);
    if (edge.circle) {
      // The far side of the arc: the level curve of its centre at level - radius.
      LevelCurve f = level_curves[i];
      f.c -= f.k * edge.c;
      put(f.moved({edge.a, edge.b}));
    }
    for (std::size_t j = 0; j < i; ++j)
      if (const auto corner = corner_level_curve(edge, level_curves[i], level_curves[j], max_min.x, max_min.y))
        put(*corner);
  }
}

}  // namespace findspace::distance
