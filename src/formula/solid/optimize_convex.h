// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Constrained extrema over what one convex set leaves: x, y, z, and the least distance to a point. Guarantee: exact;
// where the set lacks the extremal positions they are given with `attained` false. Keywords: linear programming.
#pragma once

#include <optional>

#include "distance/answer/optimum.h"
#include "distance/planar_least/extremum.h"
#include "formula/language/formula.h"
#include "formula/planar/solve_region.h"
#include "space/box/convex_set.h"

namespace findspace::formula {

/// The value is none where the set is empty, or goes on for ever. Nothing where the extremal positions are not a
/// polytope, or not those of the convex set: of grown sets, of complements. `step`: one unit of the coordinates in the
/// scene's unit.
std::optional<distance::OptimumOf<space::ConvexSet>> optimize(const space::ConvexSet& set, const exact::Real& step,
                                                              const Objective& objective, distance::Sense sense);

}  // namespace findspace::formula
