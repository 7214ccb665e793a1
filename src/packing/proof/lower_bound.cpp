// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/proof/lower_bound.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/margins/rounding.h"
#include "packing/problem/round_part.h"
#include "packing/proof/fewest_bins.h"
#include "plane/query/measure_cells_twofold.h"

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

exact::Real exact_twice_area(const Polygon& shape) {
  exact::Real sum;
  for (const Ring& ring : shape.rings)
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const LatticePoint p = ring[i] - ring[0], q = ring[i + 1] - ring[0];
      sum += exact::Real(p.x) * exact::Real(q.y) - exact::Real(p.y) * exact::Real(q.x);
    }
  return sum;
}

/// In grid steps, rounded down.
exact::Real least_twice_area(const Part& part) {
  if (!part.round) return exact_twice_area(part.shape);
  return exact::Real::from_double(part.round->twice_area() * (1 - margin::kRoundings16));
}

/// What parts can cover at most: of a round sheet the polygon about it, and of the box about it what the edge leaves.
exact::Real most_twice_area(const Problem& problem, const Sheet& sheet) {
  const LatticeBox box = box_of(sheet);
  const exact::Real edges = exact::Real(2 * problem.steps()) * exact::Real(problem.edge.numerator()) /
                            exact::Real(problem.edge.denominator());
  const exact::Real width = exact::Real(box.high.x - box.low.x) - edges,
                    height = exact::Real(box.high.y - box.low.y) - edges;
  if (width.sign() <= 0 || height.sign() <= 0) return {};
  const exact::Real within = exact::Real(2) * width * height, whole = exact_twice_area(sheet.shape);
  return within < whole ? within : whole;
}

Fraction fewest_sheets(const Problem& problem) {
  std::vector<Alike> sheets, parts;
  std::size_t fixed = 0;
  for (std::size_t k = 0; k < problem.sheets.size(); ++k) {
    const Sheet& sheet = problem.sheets[k];
    sheets.push_back({most_twice_area(problem, sheet), std::size_t(sheet.count)});
    fixed += sheets_with_fixed(problem, k);
  }
  for (const Part& part : problem.parts) parts.push_back({least_twice_area(part), std::size_t(part.demand)});
  return Fraction(int128(std::max(fixed, fewest_bins(std::move(sheets), std::move(parts)))));
}

/// Width and height at an angle in whole grid steps, rounded down.
std::pair<int128, int128> size_at(const Part& part, const Fraction& angle) {
  if (part.round) {
    const RoundPart::Form& form = part.round->at(angle, false);
    return {exact::floor(form.high.x - form.low.x), exact::floor(form.high.y - form.low.y)};
  }
  const LatticeBox box = box_of(part, angle, false);
  return {box.high.x - box.low.x, box.high.y - box.low.y};
}

/// The width at the narrowest angle at which the part fits the height; not of parts that may be tilted.
std::optional<int128> least_width(const Problem& problem, const Part& part) {
  if (part.tilt > 0) return std::nullopt;
  std::optional<int128> least;
  for (const Fraction& angle : part.angles) {
    const auto [width, height] = size_at(part, angle);
    if (Fraction(height, problem.steps()) + problem.edge + problem.edge > problem.height) continue;
    least = std::min(least.value_or(width), width);
  }
  return least;
}

}  // namespace

Fraction lower_bound(const Problem& problem) {
  if (problem.on_sheets()) return fewest_sheets(problem);
  if (problem.box) return {};
  Fraction widest;
  exact::Int256 area;
  plane::Twofold round_area;
  for (const Part& part : problem.parts) {
    if (part.demand == 0) continue;
    if (const auto width = least_width(problem, part)) widest = std::max(widest, Fraction(*width, problem.steps()));
    if (part.round) round_area += plane::Twofold(part.demand * twice_area(part));
    for (const Ring& ring : part.round ? std::vector<Ring>{} : part.shape.rings)
      for (int copy = 0; copy < part.demand; ++copy) area += twice_area(ring);
  }
  const double steps = double(problem.steps());
  const double length = (area.to_double() + round_area.value()) / 2 / steps / steps /
                        (problem.height - problem.edge - problem.edge).to_double();
  constexpr double kDecimals = 1000000;
  const double safe = std::floor(length * (1 - margin::kRoundings16) * kDecimals);
  return std::max(widest, Fraction(int128(safe), int128(kDecimals))) + problem.edge + problem.edge;
}

}  // namespace findspace::packing
