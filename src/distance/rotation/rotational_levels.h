// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A rotational distance f (rotational_distance.h) against a level, from extrema of a plain distance g that is negative,
// 0 or positive where f is at no turn: g is gamma1 for gamma, mu of B to A for eta, mu of A to B for delta.
//   f <= l (l >= 0)  where  min of g over turns by |angle| <= l  is at most 0;
//   f <  l (l < 0)   where  max of g over turns by |angle| <= -l  is below 0;
//   second kind: f < l where there is contact, but none at turns from l on.
// Guarantee: bounds of the extrema give bounds of the sign of f - l, low <= true sign <= high. Maps may be of positions
// or of angles. Source: distances.md 7.2. Keywords: angular clearance, interval bound.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "distance/planar/shape_pair.h"
#include "distance/planar_least/extremum.h"
#include "plane/complex/overlay.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::distance {

/// A map of signs known between bounds.
template <class Map>
struct Bounded {
  Map low, high;
};
using BoundedMaps = Bounded<plane::SignMap>;
using BoundedRotations = Bounded<plane::RotationMap>;

/// g of the rotational distance f.
inline Which plain_of(Which which) {
  if (which == Which::kGamma1 || which == Which::kGamma2) return Which::kGamma1;
  return which == Which::kEta1 || which == Which::kEta2 ? Which::kMu : Which::kMuBack;
}

inline bool is_second_kind(Which which) {
  return which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2;
}

/// The signs that a distance minus its level can have.
struct SignRange {
  plane::Mark low, high;
};

using RangeRule = SignRange (*)(std::span<const plane::Mark>);

template <class Map>
Bounded<Map> combined(std::span<const Map* const> maps, RangeRule rule) {
  using plane::overlay;
  return {overlay(maps, [rule](std::span<const plane::Mark> m) { return rule(m).low; }),
          overlay(maps, [rule](std::span<const plane::Mark> m) { return rule(m).high; })};
}

/// From the bounds of the least (greatest) g within the level.
SignRange near_above(std::span<const plane::Mark> within);
SignRange near_below(std::span<const plane::Mark> within);
/// From the bounds of the least g beyond the level, and within it; at 180 degrees nothing is beyond but the opposite.
SignRange far(std::span<const plane::Mark> beyond_and_within);
SignRange far_opposite(std::span<const plane::Mark> beyond_and_within);
SignRange far_above_all(std::span<const plane::Mark> within);

/// The sign of f - level (degrees). over(from, to, sense): bounds of the sign of the extremum of g over the turns.
template <class Map, class Over>
Bounded<Map> rotational_bounds(Which which, const exact::Real& level, const Map& nowhere, const Over& over) {
  const exact::Real half(180), span = std::min(abs(level), half);
  const auto near = [&](Sense sense, RangeRule rule) {
    const Bounded<Map> m = over(-span, span, sense);
    return combined<Map>(std::array<const Map*, 2>{&m.low, &m.high}, rule);
  };
  if (!is_second_kind(which)) {
    if (level.sign() == 0) return over(span, span, Sense::kMinimum);
    return level.sign() > 0 ? near(Sense::kMinimum, near_above) : near(Sense::kMaximum, near_below);
  }
  if (level.sign() < 0) return {nowhere, nowhere};
  if (level > half) return near(Sense::kMinimum, far_above_all);
  const Bounded<Map> within = over(-span, span, Sense::kMinimum),
                     beyond = over(span, exact::Real(360) - span, Sense::kMinimum);
  return combined<Map>(std::array<const Map*, 4>{&beyond.low, &beyond.high, &within.low, &within.high},
                       level == half ? far_opposite : far);
}

}  // namespace findspace::distance
