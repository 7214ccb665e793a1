// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SurfaceSide: how far B + p, which does not lie in A, protrudes from it.
#include "distance/search/convex_distance.h"
#include "distance/search/solid_protrusion.h"
#include "distance/surface/surface_field.h"
#include "distance/surface/surface_pair.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::Vector;

namespace {

std::vector<space::Point> corners_of(const space::SurfaceSet& set) {
  std::vector<space::Point> out;
  for (const auto& sheet : set.sheets()) out.insert(out.end(), sheet->body.points.begin(), sheet->body.points.end());
  return out;
}

/// The balls, and the box about the surfaces; what lies outside these is decided by the field.
Solids solids_about(const SurfaceField& field) {
  Solids out;
  for (const auto& ball : field.set().balls()) {
    const Vector center = space::plus(exact::approx(ball.center), field.by());
    out.round.push_back({center, center, ball.radius.to_double()});
  }
  if (field.set().sheets().empty()) return out;
  for (const space::Point& v : corners_of(field.set()))
    out.corners.push_back(space::plus(exact::approx(v), field.by()));
  const space::Extent box = field.box();
  out.cells = tetrahedra_of_box(box.low, box.high);
  return out;
}

Answer exact_distance(const space::SurfaceSet& a, const RealVector& at) {
  NearestBall nearest(at);
  for (const auto& sheet : a.sheets()) nearest.offer(way_to(*sheet, at), Real());
  for (const auto& ball : a.balls()) nearest.offer(space::minus(space::real(ball.center), at), ball.radius);
  return *nearest.found();
}

}  // namespace

Answer SurfaceSide::protrusion_out(const RealVector& p) const {
  const space::SurfaceSet &b = *b_.surface, &a = *a_.surface;
  const SurfaceField of_a(a, {}), of_b(b, space::rounded(p));
  SolidOfSurface about{&of_b, {}};
  if (b_.outline) about.hull = b_.outline->parts[0].planes();
  const auto& parts = b_.parts;
  const SolidMaxMin found =
      parts ? surface_max_min(solids_of(*parts, p), nullptr, of_a) : surface_max_min(solids_about(of_b), &about, of_a);
  return protrusion_answer(found, corners_of(b), p, [&](const RealVector& at) { return exact_distance(a, at); });
}

}  // namespace findspace::distance
