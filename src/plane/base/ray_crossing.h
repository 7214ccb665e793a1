// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How a path that turns around a point crosses the ray from it to the right, tilted up by an infinitesimal: what a
// winding number at a point of the path itself counts. Guarantee: exact. Keywords: displaced winding number.
#pragma once

#include "exact/planar/geometry.h"

namespace findspace::plane {

struct Heading {
  std::int64_t x, y;
  Heading operator-() const { return {-x, -y}; }
};

/// +1 or -1 where a path that turns from one direction to another around the point, counter-clockwise for rotation
/// +1, crosses the ray upwards or downwards; else 0. The turn is of less than a full round.
inline int ray_crossing(Heading from, Heading to, int rotation) {
  if (rotation == 0) return 0;
  if (rotation < 0) return -ray_crossing(to, from, 1);
  auto level = [](Heading v) { return v.y == 0 && v.x > 0; };  // along the ray, just below it
  auto half = [](Heading v) { return v.y > 0 || (v.y == 0 && v.x > 0) ? 0 : 1; };
  exact::int128 cross = exact::int128(from.x) * to.y - exact::int128(from.y) * to.x;
  bool same = cross == 0 && exact::int128(from.x) * to.x + exact::int128(from.y) * to.y > 0;
  if (same || level(to)) return 0;
  if (level(from)) return 1;
  // Counter-clockwise from a larger angle in (0, 360) to a smaller one passes the ray.
  bool larger = half(from) != half(to) ? half(from) > half(to) : cross < 0;
  return larger ? 1 : 0;
}

}  // namespace findspace::plane
