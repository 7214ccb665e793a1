// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The extreme coordinate, or the least or greatest distance to a point, over intervals of a line of space. Guarantee:
// exact, or on the side on which the intervals are known. Cost: linear in the intervals. Keywords: objective,
// one-dimensional optimisation.
#pragma once

#include <optional>
#include <vector>

#include "distance/answer/optimum.h"
#include "distance/planar_least/extremum.h"
#include "formula/language/formula.h"
#include "formula/solid/solve_space.h"
#include "plane/query/locate_line.h"

namespace findspace::formula {

using LineOptimum = distance::OptimumOf<std::vector<plane::LineInterval>>;

/// `set`: by the length from `line.through`, in grid steps of `step`; `side`: of the true set.
LineOptimum optimize(const std::vector<plane::LineInterval>& set, const SpaceLine& line, const exact::Real& step,
                     const Objective& objective, distance::Sense sense, Side side = Side::kExact);

}  // namespace findspace::formula
