// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/rounded_phi.h"

#include <findspace/error.h>

#include "space/phi/phi_level.h"

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

RoundedAt by_distance(const RoundedPair& pair, const RealVector& u) {
  return at_distance(squared_gap(pair, u), pair.radius, direction(pair, u));
}

RoundedAt value_at(const RoundedPair& pair, const RealVector& u) {
  if (!pair.phi) return by_distance(pair, u);
  PhiAt core = phi_at(*pair.phi, u);
  return at_cores(
      CoreAt<Vector>{core.state, core.max_form, core.gradient, std::move(core.active)}, pair.radius,
      [&] { return by_distance(pair, u); },
      [&] {
        return Away<Vector>{core.distance, pair.phi->normalised_gradient(rounded(u))};
      });
}

PhiFunction function_of(const BodyPart& p, const BodyPart& q) {
  if (!q.core) return PhiFunction(ContactSurface(*p.core, q.center));
  if (!p.core) return PhiFunction(ContactSurface(p.center, *q.core));
  return PhiFunction(*p.core, *q.core);
}

void check_reach(const RealVector& u) {
  const Vector near = rounded(u);
  check_position({near.x, near.y, near.z});
}

}  // namespace

RoundedPhi::RoundedPhi(std::span<const BodyPart> a, std::span<const BodyPart> b)
    : pairs_(all_pairs<RoundedPair>(a, b, [](RoundedPair& pair, const BodyPart& p, const BodyPart& q) {
        if (!p.flat.empty() || !q.flat.empty())
          throw Error(ErrorCode::kUnsupported, "the Phi-function of a capsule, or of a flat core, is not made");
        if (p.core || q.core)
          pair.phi.emplace(function_of(p, q));
        else
          pair.apex = p.center - q.center;
      })) {}

RoundedPhi::At RoundedPhi::at(const RealVector& u) const {
  check_reach(u);
  return least_at<Vector>(pairs_, [&](const RoundedPair& pair) { return value_at(pair, u); });
}

int RoundedPhi::compare_distance(const RealVector& u, const Real& rho) const {
  check_reach(u);
  return least_sign(pairs_, [&](const RoundedPair& pair) {
    const int side = pair.phi ? sign_at(*pair.phi, u) : 1;
    return compare_to(rho, pair.radius, side, [&] { return squared_gap(pair, u); });
  });
}

}  // namespace findspace::space
