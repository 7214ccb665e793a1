// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least or greatest value of a distance over a region given on rays. Best first over groups of intervals, then over
// parts of single ones: a distance changes by no more than the length of a step, so none in a box is better than that
// at its centre by more than half the diagonal. Guarantee: of the places on the lines no one is better than `bound`;
// `value` is that at `at`, both to the rounding of a double. They agree to 2^-20 of the region's size, unless
// kMostPlaces values were not enough. Between the lines there may be better places. Keywords: constrained minimum,
// Lipschitz optimisation, branch and bound.
#pragma once

#include <functional>
#include <optional>
#include <vector>

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

}  // namespace findspace::formula
