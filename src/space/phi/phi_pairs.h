// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the Phi-functions of unions of rounded convex parts have in common in the plane (planar_phi_union.h) and in
// space (rounded_phi.h): for a pair with cores P, Q and R the sum of their radii the max form of the cores (R = 0), or
// the distance of the cores less R outside and the max form less R inside (R > 0); of a union the least of all pairs.
// `Vec` is the vector of doubles. Guarantee: states and signs are exact, values right to 2^-50. Source: phi.md 7, 10.
// Keywords: phi-function of composed objects.
#pragma once

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "exact/number/real.h"
#include "space/phi/phi_function.h"
#include "space/phi/phi_level.h"

namespace findspace::space {

template <class Vec>
struct PairAt {
  State state = State::kContact;
  double phi = 0, normalised = 0;
  double distance = 0;      // of the bodies; 0 unless apart
  Vec gradient;             // of `phi`
  Vec normalised_gradient;  // of `normalised`
  std::vector<int> active;  // facets (edges) of the cores that are highest at u, ties included
};

template <class Vec>
struct LeastAt {
  PairAt<Vec> at;
  int pair = 0;  // whose Phi is least
};

inline State state_of(int sign) { return sign < 0 ? State::kOverlap : sign > 0 ? State::kApart : State::kContact; }

/// A pair made of every two parts, those of B in turn for each of A.
template <class Pair, class Part, class Make>
std::vector<Pair> all_pairs(std::span<const Part> a, std::span<const Part> b, Make&& make) {
  if (a.empty() || b.empty()) throw Error(ErrorCode::kGeometry, "a union of convex parts needs at least one part");
  std::vector<Pair> pairs;
  pairs.reserve(a.size() * b.size());
  for (const Part& p : a)
    for (const Part& q : b) {
      Pair& pair = pairs.emplace_back();
      pair.radius = p.radius + q.radius;
      make(pair, p, q);
    }
  return pairs;
}

/// At a place that is not inside the cores' difference, by their squared distance; `gradient` leads away from it.
template <class Vec>
PairAt<Vec> at_distance(const exact::Real& square, const exact::Real& radius, const Vec& gradient) {
  const exact::Real rest = square - radius * radius;
  PairAt<Vec> at;
  at.state = state_of(rest.sign());
  // d - R = (d^2 - R^2) / (d + R), without cancellation.
  const double over = rest.to_double();
  at.phi = at.normalised = std::isnormal(over) || at.state == State::kContact
                               ? over / (root(square) + radius.to_double())
                               : (rest / (sqrt(square) + radius)).to_double();
  at.gradient = at.normalised_gradient = gradient;
  return at;
}

/// How far the cores are apart, and the unit vector from the nearest point of their difference to u.
template <class Vec>
struct Away {
  double distance = 0;
  Vec direction;
};

/// The cores at u: their state, max form, gradient and highest facets.
template <class Vec>
struct CoreAt {
  State state = State::kContact;
  double max_form = 0;
  Vec gradient;
  std::vector<int> active;
};

/// `outside()`: the pair by distance; `away()`: of the cores, where they are apart.
template <class Vec, class Outside, class AwayAt>
PairAt<Vec> at_cores(CoreAt<Vec> core, const exact::Real& radius, Outside&& outside, AwayAt&& away) {
  const bool round = radius.sign() > 0, apart = core.state == State::kApart;
  PairAt<Vec> at;
  if (round && apart) {
    at = outside();
  } else {
    at.state = round ? State::kOverlap : core.state;
    at.phi = core.max_form - radius.to_double();
    at.gradient = core.gradient;
    const Away<Vec> normalised = apart ? away() : Away<Vec>{at.phi, core.gradient};
    at.normalised = normalised.distance;
    at.normalised_gradient = normalised.direction;
  }
  at.active = std::move(core.active);
  return at;
}

/// The sign of (normalised form) - rho, rho >= 0: from the sign of the cores' max form (1 for two points) and
/// `square()`, their squared distance where it is positive.
template <class Square>
int compare_to(const exact::Real& rho, const exact::Real& radius, int side, Square&& square) {
  const exact::Real limit = radius + rho;
  if (side < 0 || (side == 0 && limit.sign() > 0)) return -1;
  return side == 0 ? 0 : compare(square(), limit * limit);
}

/// The least of all pairs.
template <class Vec, class Pair, class ValueAt>
LeastAt<Vec> least_at(const std::vector<Pair>& pairs, ValueAt&& value_at) {
  LeastAt<Vec> best{value_at(pairs[0]), 0};
  Away<Vec> least{best.at.normalised, best.at.normalised_gradient};
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    PairAt<Vec> here = value_at(pairs[k]);
    if (here.normalised < least.distance) least = {here.normalised, here.normalised_gradient};
    // States order overlap < contact < apart; next to contact they are the exact part of the comparison.
    if (here.state < best.at.state || (here.state == best.at.state && here.phi < best.at.phi))
      best = {std::move(here), static_cast<int>(k)};
  }
  best.at.normalised = least.distance;
  best.at.normalised_gradient = least.direction;
  best.at.distance = best.at.state == State::kApart ? least.distance : 0;
  return best;
}

template <class Pair, class Sign>
int least_sign(const std::vector<Pair>& pairs, Sign&& sign) {
  int least = 1;
  for (const Pair& pair : pairs) {
    least = std::min(least, sign(pair));
    if (least < 0) break;
  }
  return least;
}

}  // namespace findspace::space
