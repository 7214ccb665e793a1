// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rated_gap.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "distance/planar/hausdorff.h"
#include "plane/build/hull.h"
#include "plane/complex/overlay.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

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
  const std::array<const Region*, 2> both{&*hull, &r};
  return plane::is_empty(plane::subtract(both));
}

namespace {

Region beside(const Region& s) { return plane::closure(plane::complement(s)); }

/// The closure of what lies deeper in s.
Region deep_in(const Region& s, const Real& depth) {
  return plane::closure(plane::plain_offset(plane::interior(s), -depth));
}

/// Parts of A without inside are no deeper than 0 in themselves, but deep in B.
bool asks_for_points_of(const Region& a) { return !plane::is_regular(a) && plane::is_bounded(a); }

}  // namespace

SignMap RatedGap::lower(const Real& level, const Real& off) const {
  const TDistancePointer gap = pair_.distance(Which::kGamma1);
  if (convex_ || off.sign() == 0 || level.sign() >= 0) return gap->sign_map(level + off);
  // Shapes at a distance of `off` do not overlap; of others no depth is certain.
  return plane::remark(gap->sign_map(off), [](Mark k) { return Mark(k < 0 ? -1 : 1); });
}

SignMap RatedGap::upper(const Real& level, const Real& off) const {
  const Real least = level - off;
  if (convex_ || off.sign() == 0 || least.sign() >= 0) return pair_.distance(Which::kGamma1)->sign_map(least);
  // v is below `least` where B reaches what lies deeper in A.
  const Region &b = pair_.moving(), &a = pair_.fixed();
  SignMap of_b = plane::contact_map(deep_in(a, -least), b);
  if (!asks_for_points_of(a)) return of_b;
  const SignMap of_a = plane::contact_map(a, deep_in(b, -least));
  return plane::overlay(std::array{&std::as_const(of_b), &of_a},
                        [](std::span<const Mark> m) { return std::min(m[0], m[1]); });
}

double RatedGap::value(const RealPoint& p) const {
  const Region &b = pair_.moving(), &a = pair_.fixed();
  const auto deepest = [](const Region& s, const Region& in, const RealPoint& at) {
    const auto v = DirectedHausdorff(s, beside(in)).value(at);
    return v && !v->minus_infinity ? std::max(0.0, outward(v->bounds()).lower) : 0.0;
  };
  const double of_b = deepest(b, a, p);
  return -(asks_for_points_of(a) ? std::max(of_b, deepest(a, b, {-p.x, -p.y})) : of_b);
}

ValueRange RatedGap::depth(const RealPoint& p, const Real& off) const {
  const Region &b = pair_.moving(), &a = pair_.fixed();
  const auto gap = [&](const Region& moving, const Region& fixed) {
    const auto v = ShapePair(moving, fixed).distance(Which::kGamma1)->value(p);
    if (!v) return ValueRange{0, 0};  // nothing is in the way
    if (v->minus_infinity) return ValueRange{-exact::kInfinity, -exact::kInfinity};
    const auto bounds = outward(v->bounds());
    return ValueRange{std::min(0.0, bounds.lower), std::min(0.0, bounds.upper)};
  };
  // A place where all such pairs are free is one at a distance of `off`; where one is free B reaches nothing deeper.
  double high = gap(b, deep_in(a, off)).high;
  if (asks_for_points_of(a)) high = std::min(high, gap(deep_in(b, off), a).high);
  return {gap(b, plane::plain_offset(a, off)).low, high};
}

}  // namespace findspace::distance
