// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/name_place.h"

#include <optional>

namespace findspace::space {

using exact::Real;

namespace {

/// normal . y = offset.
struct Carrier {
  RealVector normal;
  Real offset;
};

/// The place of all carriers nearest to y; nothing where they are parallel.
std::optional<RealVector> place_of(std::span<const Carrier> carriers, const RealVector& y) {
  if (carriers.empty()) return y;
  const auto off = [&](std::size_t k) { return carriers[k].offset - dot(carriers[k].normal, y); };
  const RealVector& u = carriers[0].normal;
  if (carriers.size() == 1) return along(y, off(0) / dot(u, u), u);
  const RealVector &v = carriers[1].normal, axis = cross(u, v);
  const bool line = carriers.size() == 2;
  const RealVector& w = line ? axis : carriers[2].normal;
  const Real size = dot(axis, w);
  if (size.sign() == 0) return std::nullopt;
  RealVector way = plus(scaled(off(0) / size, cross(v, w)), scaled(off(1) / size, cross(w, u)));
  if (!line) way = plus(way, scaled(off(2) / size, axis));
  return plus(y, way);
}

/// Any within the carriers, at most one.
RealVector any_way(std::span<const Carrier> carriers) {
  const RealVector first{Real(1), Real(0), Real(0)}, second{Real(0), Real(1), Real(0)};
  if (carriers.empty()) return first;
  const RealVector aside = cross(carriers[0].normal, first);
  return is_zero(aside) ? cross(carriers[0].normal, second) : aside;
}

}  // namespace

std::vector<RealVector> name_places(std::span<const HalfSpace> planes, std::span<const Ball> spheres,
                                    const RealVector& p) {
  if (planes.size() + spheres.size() > 3) return {};
  // As seen from the first centre.
  const RealVector from = spheres.empty() ? p : spheres[0].center;
  std::vector<Carrier> carriers;
  for (const HalfSpace& h : planes) carriers.push_back({h.normal, -h.value(from)});
  for (std::size_t k = 1; k < spheres.size(); ++k) {
    const RealVector n = minus(spheres[k].center, from);
    const Real &r = spheres[0].radius, &s = spheres[k].radius, square = dot(n, n);
    if (square.sign() == 0) return {};
    carriers.push_back({n, (square + r * r - s * s) / Real(2)});
  }
  const auto middle = place_of(carriers, {});
  if (!middle) return {};
  if (spheres.empty()) return {plus(from, *middle)};
  const Real rest = spheres[0].radius * spheres[0].radius - dot(*middle, *middle);
  if (rest.sign() < 0) return {};
  const RealVector center = plus(from, *middle);
  RealVector way = carriers.size() == 2 ? cross(carriers[0].normal, carriers[1].normal)
                                        : minus(*place_of(carriers, minus(p, from)), *middle);
  const bool all_as_near = is_zero(way);
  if (all_as_near) way = any_way(carriers);
  const Real t = sqrt(rest / dot(way, way));
  if (all_as_near) return {along(center, t, way)};
  return {along(center, t, way), along(center, -t, way)};
}

}  // namespace findspace::space
