// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rated_gap.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "distance/planar/derived.h"
#include "distance/planar/hausdorff.h"
#include "plane/build/hull.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::Region;
using plane::SignMap;

bool is_convex(const Region& r) {
  if (!plane::is_regular(r) || !plane::is_bounded(r)) return false;
  const auto hull = plane::try_hull(r);
  if (!hull) return false;  // it has sides that no segment of r has
  const std::array<const Region*, 2> beside{&*hull, &r};
  return plane::is_empty(plane::subtract(beside));
}

/// -v: how deep a single point lies.
TDistancePointer RatedGap::depth() const {
  const Region &b = pair_.moving(), &a = pair_.fixed();
  const auto beside = [](const Region& s) { return plane::closure(plane::complement(s)); };
  TDistancePointer of_b = std::make_shared<DirectedHausdorff>(b, beside(a));
  if (plane::is_regular(a) || !plane::is_bounded(a)) return of_b;
  // Parts of A without inside lie deep in B.
  return greater(std::move(of_b), reflected(std::make_shared<DirectedHausdorff>(a, beside(b))));
}

SignMap RatedGap::lower(const Real& level, const Real& off) const {
  const TDistancePointer gap = pair_.distance(Which::kGamma1);
  if (convex_ || off.sign() == 0 || level.sign() >= 0) return gap->sign_map(level + off);
  // Shapes at a distance of `off` do not overlap; of others no depth is certain.
  return plane::remark(gap->sign_map(off), [](Mark k) { return Mark(k < 0 ? -1 : 1); });
}

SignMap RatedGap::upper(const Real& level, const Real& off) const {
  const Real least = level - off;
  if (convex_ || off.sign() == 0 || least.sign() >= 0) return pair_.distance(Which::kGamma1)->sign_map(least);
  return plane::negated(depth()->sign_map(-least));
}

double RatedGap::value(const RealPoint& p) const {
  const auto deep = depth()->value(p);
  return deep && !deep->minus_infinity ? std::min(0.0, -outward(deep->bounds()).lower) : 0.0;
}

}  // namespace findspace::distance
