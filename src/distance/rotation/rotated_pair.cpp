// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotated_pair.h"

#include <algorithm>
#include <array>

#include "distance/planar_features/feature_pair_search.h"
#include "plane/complex/primitives.h"
#include "plane/query/topology.h"
#include "plane/rotation/rotated_free.h"

namespace findspace::distance {

using exact::Real;
using plane::Mark;
using plane::MarkSet;
using plane::Region;
using plane::RotatedContact;
using plane::RotationMap;
using plane::SignMap;

namespace {

Mark least_of(MarkSet met) { return Mark((met & plane::kNegative) != 0 ? -1 : (met & plane::kZero) != 0 ? 0 : 1); }
Mark greatest_of(MarkSet met) { return Mark((met & plane::kPositive) != 0 ? 1 : (met & plane::kZero) != 0 ? 0 : -1); }

/// The sign map of the distance of a single point to the shape.
SignMap of_point(const Region& shape, Which which, const Real& level) {
  const std::array<plane::GridPoint, 1> origin{};
  return ShapePair(plane::region_of_points(origin), shape).distance(which)->sign_map(level);
}

RotationMap combined(const RotationMap& f, const RotationMap& g, const Mark& (*choose)(const Mark&, const Mark&)) {
  const std::array<const RotationMap*, 2> both{&f, &g};
  return plane::overlay(both, [choose](std::span<const Mark> m) { return choose(m[0], m[1]); });
}

}  // namespace

RotatedPair::RotatedPair(Region b, Region a, exact::RealPoint about, exact::RealPoint to)
    : b_(std::move(b)), a_(std::move(a)), about_(std::move(about)), to_(std::move(to)) {}

RotatedPair RotatedPair::within(RotationMap set) const {
  RotatedPair out = *this;
  out.within_ = std::move(set);
  return out;
}

bool RotatedPair::asks_for_corners(Which which, const Real& level) {
  switch (which) {
    case Which::kGamma1:
      return level.sign() < 0;
    case Which::kEta1:
    case Which::kDelta1:
    case Which::kPenetration:
      return level.sign() > 0;
    case Which::kEta2:
    case Which::kDelta2:
      return level.sign() >= 0;
    default:
      return false;
  }
}

/// B over a map of A's, or A rotated back over one of B's.
RotationMap RotatedPair::contact(const SignMap& fixed, bool back, Mark (*rule)(MarkSet), MarkSet enough) const {
  const RotatedContact::Pair pair{back ? a_ : b_, fixed, back ? to_ : about_, back ? about_ : to_};
  if (!back) return RotatedContact::rotation_map(pair, rule, enough, within_);
  return plane::mirrored(RotatedContact::rotation_map(pair, rule, enough, plane::mirrored(within_)));
}

RotationMap RotatedPair::sign_map(Which which, const Real& level) const {
  switch (which) {
    case Which::kGamma1:
      return least(level);
    case Which::kGamma2:
      return greatest(Which::kGamma2, level, false);
    case Which::kEta1:
      return contained(level, false);
    case Which::kDelta1:
      return contained(level, true);
    case Which::kMu:
      return greatest(Which::kGamma1, level, false);
    case Which::kMuBack:
      return greatest(Which::kGamma1, level, true);
    case Which::kHausdorff:
      return combined(sign_map(Which::kMu, level), sign_map(Which::kMuBack, level), std::max<Mark>);
    case Which::kD1:
      return cut_off(Which::kGamma1, level, false);
    case Which::kH:
      return cut_off(Which::kMu, level, false);
    case Which::kHBack:
      return cut_off(Which::kMuBack, level, false);
    case Which::kDstar:
      return cut_off(Which::kDelta1, level, true);
    case Which::kDstarBack:
      return cut_off(Which::kEta1, level, true);
    case Which::kDiameter:
      return diameter(level);
    case Which::kPenetration:
      return cut_off(Which::kGamma1, level, true);
    case Which::kEta2:
      return free(level, true, false, true);
    case Which::kDelta2:
      return free(level, true, true, true);
  }
  return {};
}

RotationMap RotatedPair::least(const Real& level) const {
  if (level.sign() < 0) return plane::remark(free(-level, false, false, false), [](Mark k) { return Mark(-k); });
  return nearest_point(level);
}

RotationMap RotatedPair::nearest_point(const Real& level) const {
  const SignMap around_a = of_point(a_, Which::kGamma1, level);
  RotationMap map = contact(around_a, false, least_of, plane::kNegative);
  if (level.sign() > 0 || plane::is_regular(a_)) return map;
  // Curves of A inside B: interiors of B and A do not see them, U of distances.md 3.9 does.
  const SignMap around_b = of_point(b_, Which::kGamma1, level);
  return combined(map, contact(around_b, true, least_of, plane::kNegative), std::min<Mark>);
}

RotationMap RotatedPair::greatest(Which which, const Real& level, bool back) const {
  const SignMap fixed = of_point(back ? b_ : a_, which, level);
  return contact(fixed, back, greatest_of, plane::kPositive);
}

RotationMap RotatedPair::contained(const Real& level, bool back) const {
  if (level.sign() > 0) return free(level, true, back, false);
  return greatest(Which::kGamma1, level, back);
}

/// The signs of the distance of the free positions (rotated_free.h) minus a level.
RotationMap RotatedPair::free(const Real& level, bool inside, bool back, bool farthest) const {
  if (level.sign() < 0) return RotationMap::uniform(1);
  const SignMap around_a = of_point(a_, Which::kGamma1, Real()), around_b = of_point(b_, Which::kGamma1, Real());
  using plane::RotatedFree;
  const RotatedFree::Pair pair = back ? RotatedFree::Pair{a_, b_, to_, about_, around_b, around_a}
                                      : RotatedFree::Pair{b_, a_, about_, to_, around_a, around_b};
  const RotatedFree free(pair, inside ? RotatedFree::Keep::kInside : RotatedFree::Keep::kApart);
  const RotationMap there = back ? plane::mirrored(within_) : within_;
  RotationMap map = farthest ? free.farthest(level, there) : free.nearest(level, there);
  return back ? plane::mirrored(map) : map;
}

/// max(0, f), or max(0, -f).
RotationMap RotatedPair::cut_off(Which which, const Real& level, bool negated) const {
  const int above = level.sign();
  if (above < 0) return RotationMap::uniform(1);
  const int rotation = negated ? -1 : 1;
  return plane::remark(sign_map(which, negated ? -level : level),
                       [=](Mark k) { return Mark(above > 0 ? rotation * k : rotation * k > 0); });
}

RotationMap RotatedPair::diameter(const Real& level) const {
  const exact::RealPoint origin;
  const FeatureTree a(a_), b(b_);
  const Real own = std::max(farthest_pair(a, a, origin).distance, farthest_pair(b, b, origin).distance);
  const Mark floor = Mark(compare(own, level));
  if (floor > 0) return RotationMap::uniform(1);
  return plane::remark(sign_map(Which::kGamma2, level), [floor](Mark k) { return std::max(k, floor); });
}

}  // namespace findspace::distance
