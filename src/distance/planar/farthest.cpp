// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/farthest.h"

#include <algorithm>
#include <cmath>

#include "distance/planar_features/point_set.h"
#include "distance/planar_features/smallest_circle.h"
#include "exact/margins/planar_distance.h"
#include "findspace/error.h"
#include "plane/build/hull.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::SignMap;

namespace {

/// The convex hull of a set, which has the same farthest points; the set itself where its hull cannot be represented.
plane::Region outline(const plane::Region& set) {
  exact::Tried<plane::Region> hull = plane::try_hull(set);
  return hull ? *std::move(hull) : set;
}

SignMap point_map(const RealPoint& p) { return point_set({&p, 1}, 0, 1); }

}  // namespace

Farthest::Farthest(const SignMap& base) : set_(plane::remark(base, [](Mark m) { return Mark(m <= 0); })) {
  features_ = distance::features(set_, [](Mark m) { return m > 0; });
  std::erase_if(features_, [](const BoundaryFeature& s) { return !s.is_vertex() && !s.arc; });
  defined_ = set_.faces[0].mark == 0 && !features_.empty();
}

Farthest Farthest::from_point(const RealPoint& q) { return Farthest(point_map(q)); }

SignMap Farthest::sign_map(const Real& level) const {
  int side = level.sign();
  if (!defined_ || side < 0) return CellComplex::uniform(1);
  if (side == 0) {
    // Only a single point is within 0 of one position.
    bool single = set_.vertices.size() == 1 && set_.edges.empty();
    return single ? point_map(set_.geometry.exact(set_.vertices[0].point)) : CellComplex::uniform(1);
  }
  // All of C within the disc about p: -C + p in the disc about the origin.
  return containment_map(plane::region_of_disc(0, 0, level), mirrored(outline(set_)));
}

Farthest::Best Farthest::best(const RealPoint& p) const {
  double x = near_value(p.x), y = near_value(p.y), most = 0, scale = std::abs(x) + std::abs(y);
  for (const BoundaryFeature& s : features_) {
    most = std::max(most, s.farthest(x, y));
    scale = std::max({scale, std::abs(s.x0), std::abs(s.y0)});
  }
  double tolerance = (scale + most) * margin::kLostByDoubles;
  std::optional<Best> best;
  for (const BoundaryFeature& s : features_) {
    if (s.farthest(x, y) < most - tolerance) continue;
    LevelCurve f = far_level_curve(set_, s);
    Real dx = f.a - p.x, dy = f.b - p.y, d = sqrt(dx * dx + dy * dy);
    Best k{d - f.c, {f.a, f.b}};
    if (s.arc && s.has_direction(s.cx - x, s.cy - y)) {
      k.at = d.sign() == 0 ? set_.geometry.exact(set_.vertices[set_.edges[s.cell.index].v0].point)
                           : RealPoint{f.a - f.c * dx / d, f.b - f.c * dy / d};
    } else if (s.arc) {
      continue;  // its ends are features
    }
    if (!best || compare_if_closed(k.distance, best->distance) > 0) best = k;
  }
  return *best;
}

std::optional<PlanarAnswer> Farthest::value(const RealPoint& p) const {
  if (!defined_) return std::nullopt;
  return exact_answer(best(p).distance, Way::kMap);
}

RealPoint Farthest::farthest_point(const RealPoint& p) const { return best(p).at; }

std::optional<TDistance::Lowest> Farthest::lowest() const {
  if (!defined_) return std::nullopt;
  const auto c = smallest_circle(set_, features_);
  return c ? std::optional(Lowest{c->radius, c->center}) : std::nullopt;
}

RealPoint Farthest::seed() const {
  const BoundaryFeature& s = features_.front();
  return set_.geometry.exact(s.is_vertex() ? set_.vertices[s.cell.index].point
                                           : set_.vertices[set_.edges[s.cell.index].v0].point);
}

std::optional<std::vector<SmoothForm>> Farthest::forms(const RealPoint& p, double radius) const {
  const double x = near_value(p.x), y = near_value(p.y);
  double most = 0;
  for (const BoundaryFeature& s : features_) most = std::max(most, s.farthest(x, y));
  const double reach = most - 2 * radius - (std::abs(x) + std::abs(y) + most) * margin::kLostByDoubles;
  std::vector<SmoothForm> out;
  for (const BoundaryFeature& s : features_) {
    const double cx = s.arc ? s.cx : s.x0, cy = s.arc ? s.cy : s.y0;
    SmoothForm form = ring_form(x, y, cx, cy, s.arc ? -s.r : 0, 1, radius);
    if (form.value < reach) continue;
    form.curve = [this, &s] { return far_level_curve(set_, s); };
    out.push_back(std::move(form));
  }
  return out;
}
std::vector<NearLevelCurve> Farthest::level_curves(const RealPoint& p, double tolerance) const {
  double x = near_value(p.x), y = near_value(p.y), most = 0;
  for (const BoundaryFeature& s : features_) most = std::max(most, s.farthest(x, y));
  std::vector<NearLevelCurve> out;
  for (const BoundaryFeature& s : features_) {
    double d = s.arc ? std::hypot(x - s.cx, y - s.cy) + s.r : s.farthest(x, y);
    if (std::abs(most - d) <= tolerance) out.push_back({far_level_curve(set_, s), std::abs(most - d)});
  }
  return out;
}

}  // namespace findspace::distance
