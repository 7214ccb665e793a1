// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/proof/lower_bound.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/margins/rounding.h"

namespace findspace::packing {
namespace {

/// Twice the area of a ring in grid steps, exactly.
exact::Int256 twice_area(const Ring& ring) {
  exact::Int256 sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
    sum += exact::multiply(p.x, q.y) - exact::multiply(p.y, q.x);
  }
  return sum;
}

/// The width at the narrowest angle at which the part fits the height.
std::optional<int128> least_width(const Problem& problem, const Part& part) {
  std::optional<int128> least;
  for (const Fraction& angle : part.angles) {
    const Ring ring = rotated(part.shape, angle, false).rings[0];
    const auto lower = [](const LatticePoint& p, const LatticePoint& q) { return p.y < q.y; };
    const auto [left, right] = std::minmax_element(
        ring.begin(), ring.end(), [](const LatticePoint& p, const LatticePoint& q) { return p.x < q.x; });
    const auto [bottom, top] = std::minmax_element(ring.begin(), ring.end(), lower);
    if (Fraction(top->y - bottom->y, problem.steps()) + problem.edge + problem.edge > problem.height) continue;
    least = std::min(least.value_or(right->x - left->x), right->x - left->x);
  }
  return least;
}

}  // namespace

Fraction lower_bound(const Problem& problem) {
  Fraction widest;
  exact::Int256 area;
  for (const Part& part : problem.parts) {
    if (part.demand == 0) continue;
    if (const auto width = least_width(problem, part)) widest = std::max(widest, Fraction(*width, problem.steps()));
    for (const Ring& ring : part.shape.rings)
      for (int copy = 0; copy < part.demand; ++copy) area += twice_area(ring);
  }
  const double steps = double(problem.steps());
  const double length =
      area.to_double() / 2 / steps / steps / (problem.height - problem.edge - problem.edge).to_double();
  constexpr double kDecimals = 1000000;
  const double safe = std::floor(length * (1 - margin::kRoundings16) * kDecimals);
  return std::max(widest, Fraction(int128(safe), int128(kDecimals))) + problem.edge + problem.edge;
}

}  // namespace findspace::packing
