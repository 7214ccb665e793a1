// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of SolidSide between farthest points: those of two bodies, and within one. Two such points are
// vertices, or lie a radius beyond. Guarantee: exact; numbers choose the pairs that are compared.

#include <algorithm>

#include "distance/solid/solid_pair.h"
#include "exact/margins/rounding.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::real;
using space::RealVector;

namespace {

/// visit(part of A, part of B, vertex of A, vertex of B) for the pairs that are farthest from each other, as far as
/// numbers tell, with B moved by p.
template <class Visit>
void visit_farthest(const Body& a, const Body& b, const space::Vector& p, Visit&& visit) {
  // All of B lies within `reach` of the middle of its corners: most vertices of A are too near to that.
  space::Vector middle;
  double count = 0, reach = 0, top = 0;
  for (const BodyPart& s : b.parts) {
    for (const space::Point& w : s.vertices()) {
      middle = space::plus(middle, exact::approx(w));
      ++count;
    }
  }
  middle = space::scaled(1 / count, middle);
  for (const BodyPart& s : b.parts) {
    for (const space::Point& w : s.vertices())
      reach = std::max(reach, space::length(exact::approx(w) - middle) + s.radius.to_double());
  }
  const auto each = [&](const auto& take) {
    for (const BodyPart& t : a.parts) {
      const double radius = t.radius.to_double();
      for (const space::Point& v : t.vertices()) {
        const space::Vector at = exact::approx(v) - p;
        const double most = space::length(at - middle) + reach + radius,
                     blur = space::size_of(at) + space::size_of(middle);
        if (most * margin::kUpward + margin::kPlaceNoise * blur < top * margin::kDownward) continue;
        for (const BodyPart& s : b.parts) {
          const double r = radius + s.radius.to_double();
          for (const space::Point& w : s.vertices()) take(t, s, v, w, space::length(at - exact::approx(w)) + r);
        }
      }
    }
  };
  using space::Point;
  each([&](const BodyPart&, const BodyPart&, const Point&, const Point&, double d) { top = std::max(top, d); });
  each([&](const BodyPart& t, const BodyPart& s, const Point& v, const Point& w, double d) {
    if (d >= top * (1 - margin::kFarthestTie)) visit(t, s, v, w);
  });
}

}  // namespace

TriedAnswer SolidSide::reach(const RealVector& p) const {
  std::optional<Answer> best;
  visit_farthest(*a_, *b_, space::rounded(p), [&](const BodyPart& t, const BodyPart& s, const auto& v, const auto& w) {
    const RealVector a = real(v), b = space::plus(real(w), p), e = space::minus(a, b);
    const Real core = sqrt(space::dot(e, e)), value = core + t.radius + s.radius;
    if (best && !(best->value < value)) return;
    best = Answer{};
    best->value = value;
    if (core.sign() == 0) return;
    best->witness = point_pair(space::along(b, -(s.radius / core), e), space::along(a, t.radius / core, e));
  });
  return best;
}

Real diameter(const Body& body) {
  Real best;
  visit_farthest(body, body, {}, [&](const BodyPart& t, const BodyPart& s, const auto& v, const auto& w) {
    const RealVector e = real(v - w);
    const Real value = sqrt(space::dot(e, e)) + t.radius + s.radius;
    if (best < value) best = value;
  });
  return best;
}

}  // namespace findspace::distance
