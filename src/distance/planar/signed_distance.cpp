// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/signed_distance.h"

#include <algorithm>
#include <limits>

#include "exact/margins/rounding.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::SignMap;

SignedDistance::SignedDistance(SignMap base)
    : base_(std::move(base)), defined_(plane::any_mark(base_, [](Mark m) { return m <= 0; })) {}

SignedDistance SignedDistance::gamma1(const plane::Region& b, const plane::Region& a) {
  return SignedDistance(contact_map(a, b));
}

SignedDistance SignedDistance::eta1(const plane::Region& b, const plane::Region& a) {
  return SignedDistance(containment_map(a, b));
}

SignedDistance SignedDistance::delta1(const plane::Region& b, const plane::Region& a) {
  // A lies in B + p where A - p lies in B.
  return SignedDistance(mirrored(containment_map(b, a)));
}

SignMap SignedDistance::sign_map(const exact::Real& level) const {
  return defined_ ? level_map(base_, level) : CellComplex::uniform(1);
}

std::optional<PlanarAnswer> SignedDistance::value(const exact::RealPoint& p) const {
  if (!defined_) return std::nullopt;
  Mark sign = mark_of(base_, locate(base_, p));
  if (sign == 0) return exact_answer(exact::Real(), Way::kMap);
  auto n = sign > 0 ? nearest(
                          base_, [](Mark m) { return m <= 0; }, p)
                    : nearest(
                          base_, [](Mark m) { return m >= 0; }, p);
  if (!n) return lowest_answer(Way::kMap);  // inside everywhere
  return exact_answer(sign > 0 ? n->distance : -n->distance, Way::kMap, std::optional(n->at));
}

std::optional<std::vector<SmoothForm>> SignedDistance::forms(const RealPoint& p, double radius) const {
  if (!defined_) return std::nullopt;
  std::call_once(sides_.made, [this] {
    sides_.outside = std::make_unique<const BoundaryForms>(base_, 1);
    sides_.inside = std::make_unique<const BoundaryForms>(base_, -1);
  });
  const double x = near_value(p.x), y = near_value(p.y);
  const Mark at = mark_of(base_, locate(base_, p));
  std::vector<SmoothForm> out;
  for (const int sign : {1, -1}) {
    const BoundaryForms& side = sign > 0 ? *sides_.outside : *sides_.inside;
    // The disc has positions on the other side only if the boundary is within its radius.
    const double other = at * sign < 0 ? (sign < 0 ? *sides_.outside : *sides_.inside).nearest(x, y) : 0;
    if (other <= radius * margin::kUpward) side.add_forms(x, y, radius, out);
  }
  return out;
}

RealPoint SignedDistance::seed() const {
  if (base_.vertices.empty()) return {Real(), Real()};
  return base_.geometry.exact(base_.vertices[0].point);
}

std::vector<NearLevelCurve> SignedDistance::level_curves(const RealPoint& p, double tolerance) const {
  double x = near_value(p.x), y = near_value(p.y);
  Mark at = mark_of(base_, locate(base_, p));
  std::vector<NearLevelCurve> out;
  for (int sign : {-1, 1}) {
    // Outside the distance to marks <= 0 counts, inside minus that to marks >= 0.
    if (at * sign < 0) continue;
    auto all = distance::features(base_, [sign](Mark m) { return m * sign <= 0; });
    double least = std::numeric_limits<double>::infinity();
    for (const BoundaryFeature& s : all) least = std::min(least, s.distance(x, y));
    for (const BoundaryFeature& s : all) {
      double gap = s.distance(x, y) - least;
      if (gap <= tolerance) out.push_back({near_level_curve(base_, s, x, y, sign), gap});
    }
  }
  return out;
}

}  // namespace findspace::distance
