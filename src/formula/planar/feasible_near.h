// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The feasible region of a formula where only what is near can matter: "inside this container, clear of these
// obstacles". The containers bound the positions; an obstacle, or a part of a collection, that the moving shape cannot
// come near from any of them is never summed. For gamma1 at a level >= 0 the sign at p depends on the obstacle within
// the moving shape's reach alone (distances.md 5), in a motion on all of its way. Guarantee: the same set as
// Solver::feasible. Cost: a box test an obstacle and part, and what feasible() costs for those that are near. Where a
// formula has no exact region: solve_region.h. Keywords: findspace, locality, culling, spatial index, bounding box.
#pragma once

#include <optional>

#include "formula/planar/solve.h"
#include "plane/query/nearest.h"

namespace findspace::formula {

/// {p : the formula holds at p}, over the time of a motion where there is one.
plane::Region feasible_near(const Solver& solver, const Formula& formula);

/// Whether the formula bounds the positions and asks something else of them. For another one this is feasible().
bool is_solved_near(const Solver& solver, const Formula& formula);

/// The position nearest to p, in grid steps, at which the formula holds, or of the closure of those, from windows that
/// grow about p; nothing where it is not in one that is small beside the whole world, or where not all is local.
/// `least`: none is nearer than that.
std::optional<plane::NearestInClosure> nearest_in_windows(const PreparedWorld& world, const Formula& formula,
                                                          const exact::RealPoint& p, const exact::Real& least);

}  // namespace findspace::formula
