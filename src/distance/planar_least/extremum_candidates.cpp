// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/extremum_candidates.h"

#include <algorithm>
#include <cmath>

#include "distance/planar_features/curved_level_curve.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/union_find.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Index;
using plane::Region;

namespace {

constexpr std::size_t kMostPlaces = 12, kMostAtPlace = 8, kMostLevelCurves = 20;

struct Place {
  double x, y;
};

/// Some vertices of the set, far from each other.
std::vector<Place> places(const CellComplex& reached) {
  std::vector<Place> all, out;
  for (const auto& v : reached.vertices)
    if (v.mark > 0) all.push_back({reached.geometry.points[v.point].x, reached.geometry.points[v.point].y});
  if (all.empty()) return out;
  std::vector<double> apart(all.size(), std::numeric_limits<double>::infinity());
  for (std::size_t next = 0; out.size() < kMostPlaces;) {
    Place p = all[next];
    out.push_back(p);
    for (std::size_t k = 0; k < all.size(); ++k)
      apart[k] = std::min(apart[k], std::hypot(all[k].x - p.x, all[k].y - p.y));
    next = std::size_t(std::max_element(apart.begin(), apart.end()) - apart.begin());
    if (apart[next] == 0) break;
  }
  return out;
}

bool close(const Real& p, const Real& q) {
  const double u = near_value(p), v = near_value(q);
  return std::abs(u - v) <= margin::kSameCandidate * (1 + std::abs(u));
}

template <std::size_t n>
bool close(const std::array<Real, n>& u, const std::array<Real, n>& v) {
  return std::equal(u.begin(), u.end(), v.begin(), [](const Real& p, const Real& q) { return close(p, q); });
}

bool same(const Bend& f, const Bend& g) {
  return close(f.weight, g.weight) && close(f.t, g.t) && close(f.along, g.along) && close(f.across, g.across);
}

bool same(const LevelCurve& f, const LevelCurve& g) {
  if (f.circle != g.circle || !f.bend != !g.bend) return false;
  if (f.bend && !same(*f.bend, *g.bend)) return false;
  return close(f.a, g.a) && close(f.b, g.b) && close(f.c, g.c) && close(f.k, g.k);
}

void add_new(std::vector<LevelCurve>& level_curves, const LevelCurve& f, std::size_t most) {
  if (level_curves.size() < most &&
      std::none_of(level_curves.begin(), level_curves.end(), [&](const LevelCurve& g) { return same(f, g); }))
    level_curves.push_back(f);
}

class Collector {
 public:
  Collector(double low, double high) : low_(low), high_(high) {}

  void take(const Real& level) {
    auto i = level.interval();
    if (i.hi >= low_ && i.lo <= high_) levels_.push_back(level);
  }
  void take(const std::vector<Event>& all) {
    for (const Event& e : all) take(e.level);
  }
  /// Where they meet.
  void take_meetings(const std::vector<const LevelCurve*>& level_curves) {
    if (std::any_of(level_curves.begin(), level_curves.end(), [](const LevelCurve* f) { return f->bend != nullptr; }))
      for (const Real& level : curved_levels(level_curves, low_, high_)) take(level);
    else
      take(level_curves.size() == 2 ? events(*level_curves[0], *level_curves[1])
                                    : events(*level_curves[0], *level_curves[1], *level_curves[2]));
  }
  std::vector<Real> sorted() && {
    std::stable_sort(levels_.begin(), levels_.end(),
                     [](const Real& p, const Real& q) { return near_value(p) < near_value(q); });
    return std::move(levels_);
  }

 private:
  double low_, high_;
  std::vector<Real> levels_;
};

/// Rational ones first among those of about one value: they make the cheapest proofs.
void simplest_first(std::vector<Real>& levels) {
  auto rank = [](const Real& r) { return r.is_rational() ? 0 : r.is_closed() ? 1 : 2; };
  std::stable_sort(levels.begin(), levels.end(), [&](const Real& p, const Real& q) { return rank(p) < rank(q); });
}

}  // namespace

std::vector<Real> extremum_candidates(const TDistance& f, const Region* over, const CellComplex& reached, double low,
                                      double high) {
  Collector out(low, high);
  for (const Real& l : f.special_levels()) out.take(l);
  double scale = 1;
  std::vector<Place> near = places(reached);
  for (const Place& p : near) scale = std::max({scale, std::abs(p.x), std::abs(p.y)});
  double width = high - low, tolerance = margin::kCandidateCurves * (width + std::sqrt(width * scale));
  std::vector<LevelCurve> moving, still;
  for (const Place& p : near) {
    auto level_curves = f.level_curves({Real::from_double(p.x), Real::from_double(p.y)}, tolerance);
    std::stable_sort(level_curves.begin(), level_curves.end(),
                     [](const NearLevelCurve& u, const NearLevelCurve& v) { return u.gap < v.gap; });
    for (const NearLevelCurve& n : level_curves)
      if (!n.curve.bend) out.take(events(n.curve));
    for (std::size_t k = 0; k < level_curves.size() && k < kMostAtPlace; ++k)
      add_new(moving, level_curves[k].curve, kMostLevelCurves);
  }
  if (over) {
    for (const BoundaryFeature& s : features(*over, [](plane::Mark m) { return m > 0; })) {
      bool close =
          std::any_of(near.begin(), near.end(), [&](const Place& p) { return s.distance(p.x, p.y) <= tolerance; });
      if (!close) continue;
      if (!s.is_vertex())
        add_new(still, fixed_level_curve(*over, s), kMostLevelCurves);
      else if (auto v = f.value(over->geometry.exact(over->vertices[s.cell.index].point)))
        out.take(v->value);
    }
  }
  std::vector<const LevelCurve*> all;
  for (const LevelCurve& m : moving) all.push_back(&m);
  for (const LevelCurve& s : still) all.push_back(&s);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      out.take_meetings({all[i], all[j]});
      for (std::size_t k = j + 1; k < all.size() && j < moving.size(); ++k) out.take_meetings({all[i], all[j], all[k]});
    }
  }
  auto levels = std::move(out).sorted();
  if (!levels.empty() && near_value(levels.back()) - near_value(levels.front()) <= scale * margin::kOneCandidate)
    simplest_first(levels);
  return levels;
}

ComponentPoints one_point_a_component(const CellComplex& c) {
  plane::UnionFind groups(Index(c.vertices.size()));
  for (const auto& e : c.edges)
    if (e.mark > 0) groups.unite(e.v0, e.v1);
  std::vector<Index> first(c.vertices.size(), plane::kNone);
  ComponentPoints out;
  for (Index v = 0; v < c.vertices.size(); ++v) {
    if (c.vertices[v].mark <= 0 || first[groups.find(v)] != plane::kNone) continue;
    first[groups.find(v)] = v;
    out.points.push_back(c.geometry.exact(c.vertices[v].point));
  }
  // A face lies no farther than its outer boundary, an arc of half a circle at most no farther than half its chord from
  // it. By exact places: where curves all but touch, doubles say little.
  const auto between = [&](Index v, Index w) {
    const RealPoint p = c.geometry.exact(c.vertices[v].point), q = c.geometry.exact(c.vertices[w].point);
    return v == w ? 0.0 : plain_length((p.x - q.x).to_double(), (p.y - q.y).to_double());
  };
  for (const auto& e : c.edges) {
    const Index v = first[groups.find(e.v0)];
    if (e.mark <= 0 || v == plane::kNone) continue;
    const double bulge = e.half != 0 ? between(e.v0, e.v1) / 2 : 0;
    out.within =
        std::max(out.within, (std::max(between(v, e.v0), between(v, e.v1)) + bulge) * (1 + margin::kFewRoundings));
  }
  if (c.faces[0].mark > 0) out.within = exact::kInfinity;
  return out;
}

}  // namespace findspace::distance
