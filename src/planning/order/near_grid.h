// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The grid point of a set nearest to a place, in the plane and in space: ring after ring of the grid's cells about that
// of the place, until no farther ring can hold a nearer one. Guarantee: the point is in the set; it is the nearest
// within the rings, where both distances are closed forms, else but for the rounding of the distances. Of several the
// one with the least z, then y, then x. Cost: where the set is thick, the corners of the place's own cell. Keywords:
// snapping, rounding, lattice point.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "exact/number/real.h"

namespace findspace::planning {

/// Nothing where no grid point within `rings` steps of the place's cell holds. The place is in grid steps.
template <std::size_t N, class Holds>
std::optional<std::array<exact::Real, N>> nearest_on_grid(const std::array<exact::Real, N>& place, int rings,
                                                          const Holds& holds) {
  using exact::Real;
  using Offset = std::array<int, N>;
  std::array<Real, N> base, rest;
  for (std::size_t k = 0; k < N; ++k) {
    base[k] = Real(exact::floor(place[k]));
    rest[k] = place[k] - base[k];
  }
  std::optional<Offset> best;
  Real least;  // its squared distance
  const auto try_offset = [&](const Offset& o) {
    std::array<Real, N> at;
    Real square;
    for (std::size_t k = 0; k < N; ++k) {
      at[k] = base[k] + Real(o[k]);
      square += (Real(o[k]) - rest[k]) * (Real(o[k]) - rest[k]);
    }
    const int order = best ? compare_if_closed(square, least) : -1;
    const auto is_lower = [&] {
      return std::lexicographical_compare(o.rbegin(), o.rend(), best->rbegin(), best->rend());
    };
    if (order > 0 || (order == 0 && !is_lower()) || !holds(at)) return;
    best = o;
    least = square;
  };
  for (int ring = 1; ring <= rings; ++ring) {
    // What is in it only is `ring - 1` away at least.
    if (best && compare_if_closed(least, Real((ring - 1) * (ring - 1))) < 0) break;
    Offset o;
    o.fill(1 - ring);
    for (bool more = true; more;) {
      if (std::any_of(o.begin(), o.end(), [&](int c) { return c == 1 - ring || c == ring; })) try_offset(o);
      std::size_t k = 0;
      while (k < N && o[k] == ring) o[k++] = 1 - ring;
      more = k < N;
      if (more) ++o[k];
    }
  }
  if (!best) return std::nullopt;
  for (std::size_t k = 0; k < N; ++k) base[k] += Real((*best)[k]);
  return base;
}

}  // namespace findspace::planning
