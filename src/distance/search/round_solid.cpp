// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/round_solid.h"

#include <algorithm>

#include "distance/search/boundary_cells.h"

namespace findspace::distance {

using space::dot;
using space::Vector;

Vector RoundSolid::projection(const Vector& x) const {
  if (way) return space::plus(x, way(x));
  const Vector e = to - from;
  const double square = dot(e, e), part = square > 0 ? std::clamp(dot(x - from, e) / square, 0.0, 1.0) : 0;
  return space::plus(from, space::scaled(part, e));
}

Vector RoundSolid::pulled_in(const Vector& x) const {
  const Vector at = projection(x), off = x - at;
  const double far = space::length(off);
  return far > radius ? space::plus(at, space::scaled(radius / far, off)) : x;
}

std::optional<std::array<double, 4>> RoundSolid::beyond_plane(const Vector& x, const Tetrahedron& corners) const {
  const Vector at = projection(x), off = x - at;
  const double far = space::length(off);
  if (!(far > radius / 2))
    return std::nullopt;  // no sign: any plane that touches is a bound, this one would be far off
  std::array<double, 4> out{};
  for (std::size_t v = 0; v < 4; ++v) out[v] = dot(off, corners[v] - at) / far - radius;
  return out;
}

/// A box, cut along the six ways from its lowest to its highest corner.
std::vector<Tetrahedron> around(const RoundSolid& solid) {
  space::Extent box{solid.from, solid.from};
  box.add({solid.to, solid.to});
  return tetrahedra_of_box(grown(box, solid.radius));
}

}  // namespace findspace::distance
