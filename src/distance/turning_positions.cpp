// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/turning_positions.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plane/moved.h"
#include "plane/overlay.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::Region;

namespace {

const Real kHalf(180), kLeg(30);  // degrees

/// Whose sign at level 0 tells contact and overlap, or containment.
Which plain_of(Which which) {
  if (which == Which::kGamma1 || which == Which::kGamma2) return Which::kGamma1;
  return which == Which::kEta1 || which == Which::kEta2 ? Which::kMu : Which::kMuBack;
}

class Turned {
 public:
  Turned(const Region& b, const Region& a, Which which, const RealPoint& centre)
      : b_(b), a_(plane::moved(a, {-centre.x, -centre.y})), which_(plain_of(which)), centre_(centre) {}

  /// The extremum of the plain distance while B turns from one angle to another, against 0.
  BoundedMaps over(const Real& from, const Real& to, Sense sense) const {
    std::vector<TurningPose> poses{pose(from)};
    for (Real at = from + kLeg; at < to; at += kLeg) poses.push_back(pose(at));
    poses.push_back(pose(to));
    return turning_maps(b_, a_, which_, poses, sense, Real());
  }

 private:
  TurningPose pose(const Real& degrees) const { return {{-centre_.x, -centre_.y}, Real(), -degrees}; }

  const Region& b_;
  Region a_;
  Which which_;
  RealPoint centre_;
};

/// The signs that a distance minus its level can have.
struct Range {
  Mark low, high;
};

BoundedMaps combined(std::span<const plane::CellComplex* const> maps, Range (*rule)(std::span<const Mark>)) {
  return {plane::overlay(maps, [rule](std::span<const Mark> m) { return rule(m).low; }),
          plane::overlay(maps, [rule](std::span<const Mark> m) { return rule(m).high; })};
}

/// From the bounds of the least (greatest) plain distance within the level.
Range near_above(std::span<const Mark> m) { return {Mark(m[0] > 0 ? 1 : -1), m[1]}; }
Range near_below(std::span<const Mark> m) { return {m[0], Mark(m[1] < 0 ? -1 : 1)}; }

/// From the bounds of the least plain distance beyond the level, and within it.
Range far(std::span<const Mark> m) {
  Range out{1, -1};
  const auto add = [&](int low, int high) {
    out.low = std::min(out.low, Mark(low)), out.high = std::max(out.high, Mark(high));
  };
  for (Mark beyond = m[0]; beyond <= m[1]; ++beyond) {
    if (beyond < 0) add(1, 1);
    if (beyond == 0) add(0, 1);
    if (beyond <= 0) continue;
    for (Mark within = m[2]; within <= m[3]; ++within) add(within > 0 ? 1 : -1, within > 0 ? 1 : -1);
  }
  return out;
}

/// At 180 degrees nothing is beyond.
Range far_opposite(std::span<const Mark> m) {
  const Range r = far(m);
  return {r.low, m[0] <= 0 && m[1] <= 0 ? Mark(0) : r.high};
}

}  // namespace

BoundedMaps turning_position_maps(const Region& b, const Region& a, Which which, const RealPoint& centre,
                                  const Real& level) {
  const Turned turned(b, a, which, centre);
  const bool second = which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2;
  const Real span = std::min(abs(level), kHalf);
  if (!second) {
    const bool above = level.sign() > 0;
    const BoundedMaps m = turned.over(-span, span, above ? Sense::kMinimum : Sense::kMaximum);
    const std::array<const plane::CellComplex*, 2> maps{&m.low, &m.high};
    return combined(maps, above ? near_above : near_below);
  }
  if (level.sign() < 0) return {plane::SignMap::uniform(1), plane::SignMap::uniform(1)};
  const BoundedMaps within = turned.over(-span, span, Sense::kMinimum);
  if (level > kHalf) {
    const std::array<const plane::CellComplex*, 2> maps{&within.low, &within.high};
    return combined(maps, [](std::span<const Mark> m) {
      return Range{Mark(m[0] > 0 ? 1 : -1), Mark(m[1] > 0 ? 1 : -1)};
    });
  }
  const BoundedMaps beyond = turned.over(span, Real(360) - span, Sense::kMinimum);
  const std::array<const plane::CellComplex*, 4> maps{&beyond.low, &beyond.high, &within.low, &within.high};
  return combined(maps, level == kHalf ? far_opposite : far);
}

}  // namespace findspace::distance
