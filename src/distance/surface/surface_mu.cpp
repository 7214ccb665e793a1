// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfacePair: how far B + p, which does not lie in A, sticks out of it.
#include <algorithm>

#include "distance/search/convex_distance.h"
#include "distance/surface/surface_pair.h"
#include "distance/surface/surface_peak.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::Vector;

namespace {

void add_corners(const space::SurfaceSet& set, const Vector& by, PeakRoom& room) {
  for (const auto& sheet : set.sheets()) {
    for (const space::Point& v : sheet->body.points) room.corners.push_back(space::plus(exact::shadow(v), by));
  }
}

/// The parts of B, which are polytopes and balls.
PeakRoom room_of_parts(const space::Body& b, const Vector& by) {
  PeakRoom room;
  for (const space::BodyPart& part : b.parts) {
    if (part.point()) {
      const Vector center = space::plus(exact::shadow(part.center), by);
      room.round.push_back({center, center, part.radius.to_double()});
      continue;
    }
    for (Tetrahedron& t : tetrahedra(*part.core)) {
      for (Vector& v : t) v = space::plus(v, by);
      room.cells.push_back(t);
    }
  }
  return room;
}

/// The balls of B, and the box about its surfaces; what lies outside these is told by the field.
PeakRoom room_of_field(const SurfaceField& field, const space::Body* hull) {
  PeakRoom room;
  for (const auto& ball : field.set().balls()) {
    const Vector center = space::plus(exact::shadow(ball.center), field.by());
    room.round.push_back({center, center, ball.radius.to_double()});
  }
  room.within = &field;
  if (field.set().sheets().empty()) return room;
  Vector low = exact::shadow(field.set().sheets()[0]->body.low), high = low;
  for (const auto& sheet : field.set().sheets()) {
    for (const Vector& v : {exact::shadow(sheet->body.low), exact::shadow(sheet->body.high)}) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  }
  room.cells = tetrahedra_of_box(space::plus(low, field.by()), space::plus(high, field.by()));
  if (hull) room.planes = hull->parts[0].planes();
  return room;
}

/// At a corner of B the exact distance; nothing where the place is none.
std::optional<SolidValue> at_corner(const space::SurfaceSet& b, const space::SurfaceSet& a, const RealVector& p,
                                    const Vector& place) {
  const Vector by = space::rounded(p);
  for (const auto& sheet : b.sheets()) {
    for (const space::Point& v : sheet->body.points) {
      if (space::length(space::plus(exact::shadow(v), by) - place) > 0x1p-44 * space::size_of(place)) continue;
      const RealVector at = space::plus(space::real(v), p);
      std::optional<SolidValue> best;
      const auto offer = [&](const RealVector& way, const Real& radius) {
        const Real core = sqrt(space::dot(way, way)), value = core - radius;
        if (best && best->value <= value) return;
        best = SolidValue{};
        best->value = value;
        if (core.sign() > 0) best->points = {at, space::along(at, value / core, way)};
      };
      for (const auto& other : a.sheets()) offer(way_to(*other, at), Real());
      for (const auto& ball : a.balls()) offer(space::minus(space::real(ball.center), at), ball.radius);
      return best;
    }
  }
  return std::nullopt;
}

}  // namespace

SolidValue SurfacePair::sticking_out(const Side& side, const RealVector& p) {
  const space::SurfaceSet &b = *side.moving->surface, &a = *side.fixed->surface;
  const Vector by = space::rounded(p);
  const SurfaceField of_a(a, {}), of_b(b, by);
  PeakRoom room =
      side.moving->parts ? room_of_parts(*side.moving->parts, by) : room_of_field(of_b, side.moving->outline.get());
  add_corners(b, by, room);
  const SurfacePeak peak = surface_peak(room, of_a);
  if (peak.whole) {
    if (auto exact = at_corner(b, a, p, peak.place)) return *exact;
  }
  SolidValue out;
  out.value = Real::from_double(peak.value);
  out.proven = false;
  out.error = peak.bound - peak.value + 0x1p-40 * space::size_of(peak.place);
  return out;
}

}  // namespace findspace::distance
