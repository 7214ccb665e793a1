// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/optimize_convex.h"

#include <algorithm>

#include "space/body/open_union.h"

namespace findspace::formula {

using exact::Real;
using space::ConvexRegion;
using space::HalfSpace;
using space::RealVector;

namespace {

/// The vertices where the coordinate is greatest, or least.
ConvexRegion end_of(ConvexRegion region, std::size_t axis, bool greatest, Real& value) {
  const auto vertices = region.vertices();
  const auto end = std::max_element(vertices.begin(), vertices.end(), [&](const auto& v, const auto& w) {
    return greatest ? v.at[axis] < w.at[axis] : w.at[axis] < v.at[axis];
  });
  value = end->at[axis];
  RealVector n;
  n[axis] = Real(greatest ? -1 : 1);
  region.cut(HalfSpace(n, greatest ? value : -value));
  return region;
}

}  // namespace

std::optional<distance::OptimumOf<space::ConvexSet>> optimize(const space::ConvexSet& set, const Real& step,
                                                              const Objective& objective, distance::Sense sense) {
  const bool greatest = sense == distance::Sense::kMaximum;
  const bool solid = set.region.dimension() == 3, held = set.frontier || (solid && set.inside);
  if (set.outside || set.radius.sign() > 0) return std::nullopt;
  // A frontier alone has the extrema of the whole.
  auto out = distance::no_optimum<space::ConvexSet>(sense, false, {ConvexRegion({}, {}), false, true, false, {}});
  if (set.region.empty() || !held) {
    out.at.frontier = false;
    return out;
  }
  out.attained = set.frontier;
  using Kind = Objective::Kind;
  if (objective.kind == Kind::kX || objective.kind == Kind::kY || objective.kind == Kind::kZ) {
    const std::size_t axis = objective.kind == Kind::kX ? 0 : objective.kind == Kind::kY ? 1 : 2;
    Real value;
    out.at.region = end_of(set.region, axis, greatest, value);
    out.set_exact(value * step, distance::Way::kConvex);
    return out;
  }
  if (objective.kind != Kind::kDistanceToPoint || greatest) return std::nullopt;
  if (solid && !set.inside) return std::nullopt;
  RealVector p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = objective.point.at(k) / step;
  const auto q = space::nearest_in(set.region.planes(), p);
  if (!q) return out;
  const auto planes = set.region.planes();
  out.attained |= std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) { return h.value(*q).sign() < 0; });
  const RealVector off = space::minus(*q, p);
  out.set_exact(sqrt(space::dot(off, off)) * step, distance::Way::kConvex);
  out.at.region = ConvexRegion(*q, *q);
  return out;
}

}  // namespace findspace::formula
