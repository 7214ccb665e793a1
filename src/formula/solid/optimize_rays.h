// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least or greatest value of a distance over a region given on rays. Best first over groups of intervals, then over
// parts of single ones: a distance is 1-Lipschitz, so none in a box is better than that
// at its centre by more than half the diagonal. Guarantee: of the places on the lines no one is better than `bound`;
// `value` is that at `at`, both to the rounding of a double. They agree to 2^-20 of the region's size, unless
// kMostPlaces values were not enough. Between the lines there may be better places. Keywords: constrained minimum,
// Lipschitz optimisation, branch and bound.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "distance/answer/optimum.h"
#include "formula/solid/side.h"
#include "space/rays/ray_intervals.h"

namespace findspace::formula {

inline constexpr int kMostPlaces = 30000;

struct RayBest {
  double value = 0, bound = 0;
  std::array<double, 3> at{};
  bool attained = false;  // the place belongs to the region
};

/// Finite intervals. `value` is called from many threads; nothing where there is no interval.
std::optional<RayBest> best_on_lines(std::vector<space::RayInterval> intervals, bool greatest,
                                     const std::function<double(const std::array<double, 3>&)>& value);

/// How lines stand to a region, in grid steps.
struct LinesOfRegion {
  Side on_lines = Side::kExact;  // of what they hold of it
  Side cells = Side::kNone;      // of the cells about them
  exact::Real cell_radius;       // no place of a cell is farther from its line
};
/// A place on the lines, and what none on them passes, as the best value over the region; `step` in the scene's unit.
/// Between the lines there may be better places. What those on the lines say of the whole region they say where the
/// cells cover it: an objective is 1-Lipschitz.
distance::OptimalValue best_over_region(const RayBest& found, distance::Sense sense, const LinesOfRegion& lines,
                                        double step);

}  // namespace findspace::formula
