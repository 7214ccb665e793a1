// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rounded_phi.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

namespace findspace::space {
namespace {

using exact::Real;

/// The squared distance of the cores at u; 0 where they meet.
Real squared_gap(const RoundedPair& pair, const RealVector& u) {
  if (pair.phi) return squared_distance(*pair.phi, u);
  const RealVector way = minus(u, real(pair.apex));
  return dot(way, way);
}

/// The unit vector from the nearest point of the cores' difference to u, which is outside.
Vector direction(const RoundedPair& pair, const RealVector& u) {
  if (pair.phi) return pair.phi->normalised_gradient(rounded(u));
  const Vector way = rounded(minus(u, real(pair.apex)));
  const double size = length(way);
  return size > 0 ? scaled(1 / size, way) : Vector{1, 0, 0};
}

State state_of(int sign) { return sign < 0 ? State::kOverlap : sign > 0 ? State::kApart : State::kContact; }

/// Where the cores are apart, or are two points: by their distance.
RoundedAt by_distance(const RoundedPair& pair, const RealVector& u) {
  const Real square = squared_gap(pair, u), rest = square - pair.radius * pair.radius;
  RoundedAt at;
  at.state = state_of(rest.sign());
  // d - R = (d^2 - R^2) / (d + R), without cancellation.
  at.phi = rest.to_double() / (std::sqrt(square.to_double()) + pair.radius.to_double());
  at.normalised = at.phi;
  at.gradient = direction(pair, u);
  return at;
}

RoundedAt value_at(const RoundedPair& pair, const RealVector& u) {
  if (!pair.phi) return by_distance(pair, u);
  PhiAt core = phi_at(*pair.phi, u);
  const bool round = pair.radius.sign() > 0;
  RoundedAt at;
  if (round && core.state == State::kApart) {
    at = by_distance(pair, u);
  } else {
    at.state = round ? State::kOverlap : core.state;
    at.phi = core.max_form - pair.radius.to_double();
    at.normalised = core.state == State::kApart ? core.distance : at.phi;
    at.gradient = core.gradient;
  }
  at.active = std::move(core.active);
  return at;
}

int compare_pair(const RoundedPair& pair, const RealVector& u, const Real& rho) {
  const Real limit = pair.radius + rho;
  const int side = pair.phi ? sign_at(*pair.phi, u) : 1;
  if (side < 0 || (side == 0 && limit.sign() > 0)) return -1;
  if (side == 0) return 0;
  return compare(squared_gap(pair, u), limit * limit);
}

PhiFunction function_of(const RoundedPart& p, const RoundedPart& q) {
  if (!q.core) return PhiFunction(ContactSurface(*p.core, q.center));
  if (!p.core) return PhiFunction(ContactSurface(p.center, *q.core));
  return PhiFunction(*p.core, *q.core);
}

}  // namespace

RoundedPhi::RoundedPhi(std::span<const RoundedPart> a, std::span<const RoundedPart> b) {
  if (a.empty() || b.empty()) throw Error(ErrorCode::kGeometry, "a union of convex parts needs at least one part");
  for (const RoundedPart& p : a) {
    for (const RoundedPart& q : b) {
      RoundedPair& pair = pairs_.emplace_back();
      pair.radius = p.radius + q.radius;
      if (p.core || q.core)
        pair.phi.emplace(function_of(p, q));
      else
        pair.apex = p.center - q.center;
    }
  }
}

RoundedPhi::At RoundedPhi::at(const RealVector& u) const {
  At best{value_at(pairs_[0], u), 0};
  double normalised = best.at.normalised;
  for (int k = 1; k < pair_count(); ++k) {
    RoundedAt here = value_at(pairs_[k], u);
    normalised = std::min(normalised, here.normalised);
    // States order overlap < contact < apart; next to contact they are the exact part of the comparison.
    if (here.state < best.at.state || (here.state == best.at.state && here.phi < best.at.phi))
      best = {std::move(here), k};
  }
  best.at.normalised = normalised;
  best.at.distance = best.at.state == State::kApart ? normalised : 0;
  return best;
}

int RoundedPhi::compare_distance(const RealVector& u, const Real& rho) const {
  int least = 1;
  for (const RoundedPair& pair : pairs_) {
    least = std::min(least, compare_pair(pair, u, rho));
    if (least < 0) break;
  }
  return least;
}

}  // namespace findspace::space
