// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/rounded_phi.h"

#include "space/phi/phi_level.h"
#include "space/polytope/flat_core.h"

namespace findspace::space {
namespace {

using exact::Real;

/// From the nearest point of a difference without interior to u.
RealVector off_flat(const RoundedPair& pair, const RealVector& u) {
  if (pair.balls()) return minus(u, real(pair.flat[0]));
  if (const auto off = off_border(pair.flat, pair.normal, u)) return *off;
  const Real height = dot(pair.normal, minus(u, real(pair.flat[0])));
  return scaled(height / dot(pair.normal, pair.normal), pair.normal);
}

/// The squared distance of the cores at u; 0 where they meet.
Real squared_gap(const RoundedPair& pair, const RealVector& u) {
  if (pair.phi) return squared_distance(*pair.phi, u);
  const RealVector way = off_flat(pair, u);
  return dot(way, way);
}

/// At a u that is not inside the cores' difference.
RoundedAt by_distance(const RoundedPair& pair, const RealVector& u) {
  if (pair.phi)
    return at_distance(squared_distance(*pair.phi, u), pair.radius, pair.phi->normalised_gradient(rounded(u)));
  const RealVector off = off_flat(pair, u);
  const Vector way = rounded(off);
  const double size = length(way);
  return at_distance(dot(off, off), pair.radius, size > 0 ? scaled(1 / size, way) : pair.aside);
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

/// Of the cores' difference.
void make_pair_of(RoundedPair& pair, const BodyPart& p, const BodyPart& q) {
  if (p.core && q.core) {
    pair.phi.emplace(*p.core, *q.core);
  } else if (p.core && q.point()) {
    pair.phi.emplace(ContactSurface(*p.core, q.center));
  } else if (p.point() && q.core) {
    pair.phi.emplace(ContactSurface(p.center, *q.core));
  } else {
    std::vector<Point> differences;
    for (const Point& v : p.vertices())
      for (const Point& w : q.vertices()) differences.push_back(v - w);
    auto corners = flat_corners(differences);
    if (!corners) {
      pair.phi.emplace(ContactSurface(p.vertices(), q.vertices()));
      return;
    }
    pair.flat = *std::move(corners);
    if (pair.balls()) return;
    const HalfSpace side = flat_planes(pair.flat)[0];
    pair.aside = side.unit;
    if (pair.flat.size() > 2) pair.normal = side.normal;
  }
}

void check_reach(const RealVector& u) {
  const Vector near = rounded(u);
  check_position({near.x, near.y, near.z});
}

}  // namespace

RoundedPhi::RoundedPhi(std::span<const BodyPart> a, std::span<const BodyPart> b)
    : pairs_(all_pairs<RoundedPair>(
          a, b, [](RoundedPair& pair, const BodyPart& p, const BodyPart& q) { make_pair_of(pair, p, q); })) {}

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
