// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The extreme coordinate, or the least or greatest distance to a point, over intervals of a line of space. Guarantee:
// exact. Cost: linear in the intervals. Keywords: objective, one-dimensional optimisation.
#pragma once

#include <optional>
#include <vector>

#include "distance/planar_least/extremum.h"
#include "formula/language/formula.h"
#include "formula/language/optimum.h"
#include "formula/solid/solve_space.h"
#include "plane/query/locate_line.h"

namespace findspace::formula {

using LineOptimum = OptimumOf<std::vector<plane::LineInterval>>;

/// `set`: by the length from `line.through`, in grid steps of `step`.
LineOptimum optimize(const std::vector<plane::LineInterval>& set, const SpaceLine& line, const exact::Real& step,
                     const Objective& objective, distance::Sense sense);

}  // namespace findspace::formula
