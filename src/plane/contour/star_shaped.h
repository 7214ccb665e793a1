// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a ring of segments between grid points is seen whole from the mean of its corners: every edge runs on in one
// direction round it, once round. Such a ring is simple, which is known so without looking at pairs of edges.
// Guarantee: exact; "no" says nothing about the ring. Cost: linear. Keywords: star-shaped polygon, kernel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "plane/contour/shape.h"

namespace findspace::plane {

/// star_shaped about `mean`, in products of this width.
template <class Wide, class At>
int star_shaped_about(const GridPoint& mean, std::size_t n, At at) {
  const auto from_mean = [&](std::size_t k) {
    const GridPoint p = at(k);
    return GridPoint{p.x - mean.x, p.y - mean.y};
  };
  const auto is_below = [](const GridPoint& p) { return p.y < 0 || (p.y == 0 && p.x < 0); };
  const auto side = [](const GridPoint& p, const GridPoint& q) { return Wide(p.x) * q.y - Wide(p.y) * q.x; };
  GridPoint from = from_mean(n - 1);
  const bool left = side(from, from_mean(0)) > 0;
  bool below = is_below(from);
  int rounds = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const GridPoint to = from_mean(k);
    const Wide there = side(from, to);
    if (there == 0 || (there > 0) != left) return 0;
    const bool was_below = std::exchange(below, is_below(to));
    rounds += was_below && !below;
    from = to;
  }
  if (rounds != 1) return 0;
  return left ? 1 : -1;
}

/// +1 round counter-clockwise, -1 clockwise, 0 if not so. `at(k)`: corner k of n > 0.
template <class At>
int star_shaped(std::size_t n, At at) {
  constexpr std::size_t kMost = std::size_t(1) << 20;  // so that sums of coordinates stay below 2^62
  if (n > kMost) return 0;
  constexpr std::int64_t kShort = std::int64_t(1) << 30;
  GridPoint mean;
  std::uint64_t reach = 0;  // below 2 kShort if no coordinate is as long as that
  for (std::size_t k = 0; k < n; ++k) {
    const GridPoint p = at(k);
    mean.x += p.x;
    mean.y += p.y;
    reach |= std::uint64_t(p.x + kShort) | std::uint64_t(p.y + kShort);
  }
  mean = {mean.x / std::int64_t(n), mean.y / std::int64_t(n)};
  if (reach < std::uint64_t(2 * kShort)) return star_shaped_about<std::int64_t>(mean, n, at);
  return star_shaped_about<exact::int128>(mean, n, at);
}

}  // namespace findspace::plane
