// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/contact_joints.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

using exact::Real;
using Kind = ContactPair::Kind;

/// Of lengths that sum up from such numbers.
bool near(double x, double y, const RoundFeature& a, const RoundFeature& b) {
  const double size = std::abs(a.x) + std::abs(a.y) + std::abs(a.r) + std::abs(b.x) + std::abs(b.y) + std::abs(b.r);
  return std::abs(x - y) <= margin::kNearFeatures * size;
}

bool one_circle(const RoundFeature& a, const RoundFeature& b) {
  return near(a.x, b.x, a, b) && near(a.y, b.y, a, b) && near(a.r, b.r, a, b) && a.radius == b.radius &&
         a.center == b.center;
}

/// The same point of both has the same normal: one circle lies in the other, radii being signed.
bool circles_touch(const RoundFeature& a, const RoundFeature& b) {
  if (!near(std::hypot(a.x - b.x, a.y - b.y), std::abs(a.r - b.r), a, b)) return false;
  const RealVector way = b.center - a.center;
  const Real radii = b.radius - a.radius;
  return plane::dot(way, way) == radii * radii;
}

bool touches(const EdgeFeature& e, const RoundFeature& a) {
  const double off = e.nx * (a.x - e.x0) + e.ny * (a.y - e.y0);
  const double size = std::abs(e.x0) + std::abs(e.y0) + std::abs(a.x) + std::abs(a.y) + std::abs(a.r);
  if (std::abs(off + a.r) > margin::kNearFeatures * size) return false;
  const RealVector n = exact_normal(e);
  return (plane::dot(n, a.center - e.p) + times_length(a.radius, n)).sign() == 0;
}

}  // namespace

ContactJoints::ContactJoints(const ContactFeatures& f) {
  const Index n = static_cast<Index>(f.rounds.size());
  for (Index a = 0; a < n; ++a) {
    Index same = 0;
    while (same < a && !(circle_[same] == same && one_circle(f.rounds[same], f.rounds[a]))) ++same;
    circle_.push_back(same);
    if (same != a) continue;
    for (Index b = 0; b < a; ++b) {
      if (circle_[b] == b && circles_touch(f.rounds[b], f.rounds[a])) touching_.insert({b, a});
    }
    for (Index e = 0; e < f.edges.size(); ++e) {
      if (touches(f.edges[e], f.rounds[a])) edges_.insert({e, a});
    }
  }
}

bool ContactJoints::rounds(Index a, Index b) const {
  const auto [low, high] = std::minmax({circle(a), circle(b)});
  return low == high || touching_.contains({low, high});
}

bool ContactTies::alike(const ContactPair& k, const ContactPair& m) const {
  const auto fixed = [&](const ContactPair& c) {
    return c.kind == Kind::kFixedEdge ? c.fixed : fixed_.circle(c.fixed);
  };
  const auto rotating = [&](const ContactPair& c) {
    return c.kind == Kind::kTurningEdge ? c.rotating : rotation_.circle(c.rotating);
  };
  return k.kind == m.kind && fixed(k) == fixed(m) && rotating(k) == rotating(m);
}

bool ContactTies::never_cross(const ContactPair& k, const ContactPair& m) const {
  if (k.kind != Kind::kRounds && m.kind == Kind::kRounds) return never_cross(m, k);
  if (k.kind != Kind::kRounds)  // of one edge
    return k.kind == m.kind && (k.kind == Kind::kFixedEdge ? k.fixed == m.fixed : k.rotating == m.rotating);
  return joined(k, m) && !is_point(k) && !is_point(m);
}

bool ContactTies::joined(const ContactPair& k, const ContactPair& m) const {
  const bool one_fixed = m.kind != Kind::kFixedEdge && fixed_.circle(k.fixed) == fixed_.circle(m.fixed);
  const bool one_rotation =
      m.kind != Kind::kTurningEdge && rotation_.circle(k.rotating) == rotation_.circle(m.rotating);
  if (m.kind == Kind::kFixedEdge) return one_rotation && fixed_.edge(m.fixed, k.fixed);
  if (m.kind == Kind::kTurningEdge) return one_fixed && rotation_.edge(m.rotating, k.rotating);
  return (one_fixed && rotation_.rounds(k.rotating, m.rotating)) || (one_rotation && fixed_.rounds(k.fixed, m.fixed));
}

/// A circle without radius, which has many normals.
bool ContactTies::is_point(const ContactPair& k) const {
  return k.kind == Kind::kRounds &&
         (curves_.fixed().rounds[k.fixed].radius + curves_.rotating().rounds[k.rotating].radius).sign() == 0;
}

}  // namespace findspace::plane
