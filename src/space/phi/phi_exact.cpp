// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/phi_exact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/margins/space.h"
#include "space/phi/phi_level.h"

namespace findspace::space {
namespace {

using exact::Real;

Level level(const Plane& plane, const RealVector& u) {
  const RealVector n = real(plane.normal);
  return {dot(n, u) + Real(plane.offset), dot(n, n)};
}

/// The squared distance of u to the polygon of facet f: to its plane where the projection is inside, else to its
/// border.
Real squared_distance_to(const PhiFunction& phi, int f, const RealVector& u) {
  const Plane& plane = phi.surface().raw_plane(f);
  std::vector<Point> corners;
  for (const int v : phi.surface().circuit(f)) corners.push_back(phi.surface().vertices()[v]);
  if (const auto off = off_border(corners, real(plane.normal), u)) return dot(*off, *off);
  const Level l = level(plane, u);
  return l.value * l.value / l.square;
}

}  // namespace

std::optional<RealVector> off_border(std::span<const Point> corners, const RealVector& n, const RealVector& u) {
  std::optional<RealVector> best;
  Real least;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const RealVector p = real(corners[i]), e = minus(real(corners[(i + 1) % corners.size()]), p), w = minus(u, p);
    if (dot(cross(e, w), n).sign() > 0) continue;
    const Real t = dot(e, w), size = dot(e, e);
    const RealVector off = t.sign() <= 0 ? w : t >= size ? minus(w, e) : along(w, -t / size, e);
    const Real d = dot(off, off);
    if (best && !(d < least)) continue;
    best = off;
    least = d;
  }
  return best;
}

PhiAt phi_at(const PhiFunction& phi, const RealVector& u) {
  const Vector near = rounded(u);
  // The rounding of u moves values by less than the error bound, whose constant allows for it.
  const double threshold = phi.max_form(near) - 4 * phi.error_bound(near);
  PhiAt result;
  Level top;
  for (int f = 0; f < phi.surface().facet_count(); ++f) {
    if (phi.plane_value(f, near) < threshold) continue;
    const Level here = level(phi.surface().raw_plane(f), u);
    const int order = result.active.empty() ? 1 : compare_levels(here, top);
    if (order > 0) {
      top = here;
      result.active.clear();
    }
    if (order >= 0) result.active.push_back(f);
  }
  const int s = top.value.sign();
  result.state = s < 0 ? State::kOverlap : s > 0 ? State::kApart : State::kContact;
  result.max_form = s == 0 ? 0 : top.value.to_double() / std::sqrt(top.square.to_double());
  result.gradient = phi.unit_normal(result.active[0]);
  if (s > 0) result.distance = root(squared_distance(phi, u));
  return result;
}

int sign_at(const PhiFunction& phi, const RealVector& u) {
  const Vector near = rounded(u);
  const double value = phi.max_form(near), bound = 2 * phi.error_bound(near);
  if (value > bound) return 1;
  if (value < -bound) return -1;
  int highest = -1;
  for (int f = 0; f < phi.surface().facet_count() && highest < 1; ++f) {
    if (phi.plane_value(f, near) < -bound) continue;
    highest = std::max(highest, level(phi.surface().raw_plane(f), u).value.sign());
  }
  return highest;
}

exact::Real squared_distance(const PhiFunction& phi, const RealVector& u) {
  if (sign_at(phi, u) <= 0) return Real(0);
  const Vector near = rounded(u), off = near - phi.nearest(near);
  // Every facet whose plane is below the distance found in doubles can hold the nearest point; of those, the ones that
  // come within its error are tried exactly.
  const double bound = phi.error_bound(near), found = std::sqrt(dot(off, off)) + 64 * bound;
  std::optional<Real> best;
  std::vector<Vector> corners;
  for (int f = 0; f < phi.surface().facet_count(); ++f) {
    const double value = phi.plane_value(f, near);
    if (value < -2 * bound || value > found) continue;
    corners.clear();
    for (const int v : phi.surface().circuit(f)) corners.push_back(phi.vertex(v));
    const Vector gap = near - nearest_on_polygon(near, phi.unit_normal(f), corners);
    if (dot(gap, gap) > found * found * (1 + margin::kFacetTried)) continue;
    const Real d = squared_distance_to(phi, f, u);
    if (!best || d < *best) best = d;
  }
  return *best;
}

}  // namespace findspace::space
