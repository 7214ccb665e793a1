// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The feasible region of a formula where only what is near can matter: "inside this container, clear of these
// obstacles". The containers bound the positions; an obstacle, or a part of a collection, that the moving shape cannot
// come near from any of them is never summed. For gamma1 at a level >= 0 the sign at p depends on the obstacle within
// the moving shape's reach alone (distances.md 5), in a motion on all of its way. Guarantee: the same set as
// Solver::feasible. Cost: a box test an obstacle and part, and what feasible() costs for those that are near. Keywords:
// findspace, locality, culling, spatial index, bounding box.
#pragma once

#include "formula/planar/solve.h"

namespace findspace::formula {

/// {p : the formula holds at p}, over the time of a motion where there is one.
plane::Region feasible_near(const Solver& solver, const Formula& formula);

}  // namespace findspace::formula
