// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// `minimize` and `maximize` of a scene over a region of positions, and the minimum behind `distance -> min`
// (docs/formula.md, distances.md 4.4): value, whether it is attained, and the positions. Objectives: a distance, x, y,
// distance to a point. Guarantee: exact where `proven` (see distance/planar_least/extremum.h). Use:
// `optimize(solver.feasible(where), objective, sense, solver)`; where the scene has no objective, `minimum_of(where,
// solver)` gives the value of its first `distance -> min`, if it has one. Keywords: constrained minimum, argmin,
// infimum.
#pragma once

#include <optional>

#include "distance/planar_least/extremum.h"
#include "formula/language/formula.h"
#include "formula/language/optimum.h"
#include "formula/planar/solve.h"

namespace findspace::formula {

using Optimum = OptimumOf<plane::Region>;

Optimum optimize(const plane::Region& region, const Objective& objective, distance::Sense sense, const Solver& solver);

/// The values of the objective, too, are known between bounds only (rotation_values.h).
bool is_bounded(const Objective& objective, const Solver& solver);
/// Where the region is known between bounds, or the values: a value that a certain position has, and `bound`, which no
/// possible one passes.
Optimum optimize(const RegionBounds& regions, const Objective& objective, distance::Sense sense, const Solver& solver);

/// The global minimum of the first `distance -> min` of a formula; nothing if it has none.
std::optional<Optimum> minimum_of(const Formula& formula, const Solver& solver);

}  // namespace findspace::formula
