// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The place nearest to a position, or farthest from it, among those at which a body B lies in A, a union of convex
// parts with radii: E of such bodies, which no convex functions describe, as B may lie partly in one part and partly in
// others. Branch and bound over tetrahedra of positions: how far B protrudes at a corner says what of a cell is not in
// E, as no step changes it by more than its length; points of B that protrude (union_protrusion.h) say so to the
// square of a cell's size: each has to be in one of few parts of A, of which all choices are tried, each a matrix
// bound_of_lp with the distance. Guarantee: doubles; `place` belongs by more than rounding, and no place of E is better
// than `bound`. Where E has no interior, that differs from `value`, or nothing is found, unless such a place is
// `known`. Cost: some hundred cells of 0.2 ms for polyhedra, of some milliseconds for a round B. Keywords: erosion,
// containment, disjunctive constraint, global optimisation.
#pragma once

#include "distance/search/union_protrusion.h"

namespace findspace::distance {

struct FitQuery {
  space::Vector from;
  bool farthest = false;
  double known = exact::kInfinity;  // the objective (the distance, or minus it) at a place that belongs
  double floor = -exact::kInfinity;
};

/// E lies in the box. `value` and `bound` are of the objective.
BoundaryPlace best_fit(const UnionProtrusion& protrusion, const space::Vector& low, const space::Vector& high,
                       const FitQuery& query);

}  // namespace findspace::distance
