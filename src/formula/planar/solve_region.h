// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The region of the plane in which a formula holds, as far as it is known, and what is best in it: the one place where
// the ways to both are tried. The region is exact where the formula has an exact one: of what is near
// (feasible_near.h), or of distances that are compared along lines and circles (sums.h). Else the answer is an inner
// and an outer set. `optimize` serves `minimize` and `maximize` over it, `minimum_of` the first `distance -> min`
// (docs/formula.md, distances.md 4.4): value, whether it is attained, and the positions. Objectives: a distance, x, y,
// distance to a point, sums. Guarantee: the true region is `region`; with `outer` it holds `region` and lies in
// `outer`. Values are exact where `proven` (see distance/planar_least/extremum.h); where the region or the values are
// known between bounds, a certain position has the value, and no possible one passes `bound`. Cost: that of the way.
// Use: `optimize(solver, solve_region(solver, where), {objective, sense})`. Keywords: feasible region, configuration
// space, inner and outer approximation, constrained minimum, argmin, infimum.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "distance/answer/optimum.h"
#include "exact/number/tried.h"
#include "formula/language/formula.h"
#include "formula/planar/region_bounds.h"
#include "formula/planar/solve.h"

namespace findspace::formula {

/// {p : the formula holds at p}, over the time of a motion where there is one; in grid steps.
SolvedRegion solve_region(const Solver& solver, const Formula& formula);
/// The same for those who ask nothing else: where they had the last pointer, the shapes go once the sign maps stand.
SolvedRegion solve_region(std::shared_ptr<const Solver> solver, const Formula& formula);
/// The same for those who can use an exact region only: refused where it is known between bounds.
exact::Tried<plane::Region> exact_region(const Solver& solver, const Formula& formula);

/// A line of positions, in grid steps; the direction is not zero.
struct PlanarLine {
  std::array<std::int64_t, 2> through{}, direction{};
  double reach = 0;  // how far from the origin, along x and y, what is asked may differ
};
/// The line with a reach that no curve of the region leaves.
PlanarLine reaching(PlanarLine line, const SolvedRegion& region);
/// The same for an objective: beyond the reach its values grow, shrink or stay the same.
PlanarLine reaching(PlanarLine line, const SolvedRegion& region, const Objective& objective, const Solver& solver);
/// Two points of the line beyond its reach, 2^36 steps or more from where it goes through: at each end all that follows
/// is as the end is.
std::array<exact::RealPoint, 2> ends_of(const PlanarLine& line);
/// The part of a region on the line, as far as its ends.
plane::Region on_line(const plane::Region& region, const PlanarLine& line);
SolvedRegion on_line(const SolvedRegion& region, const PlanarLine& line);

/// In the scene's unit, the positions in grid steps.
using Optimum = distance::OptimumOf<plane::Region>;

/// What is to be best.
struct BestQuery {
  Objective objective;
  distance::Sense sense = distance::Sense::kMinimum;
  std::optional<PlanarLine> line{};  // the region is one on it, which reaches beyond all: a best value at its ends is
                                     // none, as it goes on
};
Optimum optimize(const Solver& solver, const SolvedRegion& region, const BestQuery& query);
/// The same over an exact region, for those who can use exact values only: throws Error(kUnsupported) for an objective
/// whose values are known between bounds.
Optimum exact_optimum(const Solver& solver, const plane::Region& region, const BestQuery& query);

/// The global minimum of the first `distance -> min` of a formula; nothing if it has none.
std::optional<Optimum> minimum_of(const Formula& formula, const Solver& solver);

}  // namespace findspace::formula
