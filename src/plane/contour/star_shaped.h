// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a ring of segments between grid points is seen whole from the mean of its corners: every edge runs on in one
// direction round it, once round. Such a ring is simple, which is known so without looking at pairs of edges.
// Guarantee: exact; "no" says nothing about the ring. Cost: linear. Keywords: star-shaped polygon, kernel.
#pragma once

#include "plane/contour/shape.h"

namespace findspace::plane {

/// +1 round counter-clockwise, -1 clockwise, 0 if not so. `at(k)`: corner k of n > 0.
template <class At>
int star_shaped(std::size_t n, At at) {
  using exact::int128;
  constexpr std::size_t kMost = std::size_t(1) << 20;  // so that sums of coordinates stay below 2^62
  if (n > kMost) return 0;
  GridPoint mean;
  for (std::size_t k = 0; k < n; ++k) {
    mean.x += at(k).x;
    mean.y += at(k).y;
  }
  mean = {mean.x / std::int64_t(n), mean.y / std::int64_t(n)};
  auto below = [&](const GridPoint& p) { return p.y < mean.y || (p.y == mean.y && p.x < mean.x); };
  int rounds = 0, way = 0;
  GridPoint from = at(n - 1);
  for (std::size_t k = 0; k < n; ++k) {
    const GridPoint to = at(k);
    const int128 side = int128(from.x - mean.x) * (to.y - mean.y) - int128(from.y - mean.y) * (to.x - mean.x);
    if (side == 0 || (k > 0 && (side > 0) != (way > 0))) return 0;
    way = side > 0 ? 1 : -1;
    rounds += below(from) && !below(to);
    from = to;
  }
  return rounds == 1 ? way : 0;
}

}  // namespace findspace::plane
