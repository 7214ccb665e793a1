// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfacePair: how far B + p, which does not lie in A, protrudes from it.
#include <algorithm>

#include "distance/search/convex_distance.h"
#include "distance/surface/surface_max_min.h"
#include "distance/surface/surface_pair.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::Vector;

namespace {

void add_corners(const space::SurfaceSet& set, const Vector& by, MaxMinDomain& domain) {
  for (const auto& sheet : set.sheets()) {
    for (const space::Point& v : sheet->body.points) domain.corners.push_back(space::plus(exact::approx(v), by));
  }
}

/// The parts of B, which are polytopes and balls.
MaxMinDomain domain_of_parts(const space::Body& b, const Vector& by) {
  MaxMinDomain domain;
  for (const space::BodyPart& part : b.parts) {
    if (part.point()) {
      const Vector center = space::plus(exact::approx(part.center), by);
      domain.round.push_back({center, center, part.radius.to_double()});
      continue;
    }
    for (Tetrahedron& t : tetrahedra(*part.core)) {
      for (Vector& v : t) v = space::plus(v, by);
      domain.cells.push_back(t);
    }
  }
  return domain;
}

/// The balls of B, and the box about its surfaces; what lies outside these is decided by the field.
MaxMinDomain domain_of_field(const SurfaceField& field, const space::Body* hull) {
  MaxMinDomain domain;
  for (const auto& ball : field.set().balls()) {
    const Vector center = space::plus(exact::approx(ball.center), field.by());
    domain.round.push_back({center, center, ball.radius.to_double()});
  }
  domain.within = &field;
  if (field.set().sheets().empty()) return domain;
  Vector low = exact::approx(field.set().sheets()[0]->body.low), high = low;
  for (const auto& sheet : field.set().sheets()) {
    for (const Vector& v : {exact::approx(sheet->body.low), exact::approx(sheet->body.high)}) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  }
  domain.cells = tetrahedra_of_box(space::plus(low, field.by()), space::plus(high, field.by()));
  if (hull) domain.planes = hull->parts[0].planes();
  return domain;
}

/// At a corner of B the exact distance; nothing where the place is none.
std::optional<Answer> at_corner(const space::SurfaceSet& b, const space::SurfaceSet& a, const RealVector& p,
                                const Vector& place) {
  const Vector by = space::rounded(p);
  for (const auto& sheet : b.sheets()) {
    for (const space::Point& v : sheet->body.points) {
      if (space::length(space::plus(exact::approx(v), by) - place) > margin::kAtVertex * space::size_of(place))
        continue;
      const RealVector at = space::plus(space::real(v), p);
      std::optional<Answer> best;
      const auto offer = [&](const RealVector& way, const Real& radius) {
        const Real core = sqrt(space::dot(way, way)), value = core - radius;
        if (best && best->value <= value) return;
        best = Answer{};
        best->value = value;
        if (core.sign() > 0) best->witness = point_pair(at, space::along(at, value / core, way));
      };
      for (const auto& other : a.sheets()) offer(way_to(*other, at), Real());
      for (const auto& ball : a.balls()) offer(space::minus(space::real(ball.center), at), ball.radius);
      return best;
    }
  }
  return std::nullopt;
}

}  // namespace

Answer SurfacePair::protrusion(const Side& side, const RealVector& p) {
  const space::SurfaceSet &b = *side.moving->surface, &a = *side.fixed->surface;
  const Vector by = space::rounded(p);
  const SurfaceField of_a(a, {}), of_b(b, by);
  MaxMinDomain domain =
      side.moving->parts ? domain_of_parts(*side.moving->parts, by) : domain_of_field(of_b, side.moving->outline.get());
  add_corners(b, by, domain);
  const SolidMaxMin max_min = surface_max_min(domain, of_a);
  if (max_min.complete) {
    if (auto exact = at_corner(b, a, p, max_min.place)) return *exact;
  }
  Answer out;
  out.value = Real::from_double(max_min.value);
  out.set_unproven();
  out.error = max_min.bound - max_min.value + margin::kFoundError * space::size_of(max_min.place);
  return out;
}

}  // namespace findspace::distance
