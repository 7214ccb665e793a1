// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest feasible position, where the region is made of boxes or is one convex polytope. Exact.
#include "findspace/error.h"
#include "formula/solid/optimize_convex.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

using space::RealVector;

std::optional<NearestFeasible> nearest_feasible(const SpaceSolver& solver, const Formula& formula,
                                                const RealVector& p) {
  const exact::Real& step = solver.world().step;
  Objective to_p;
  to_p.kind = Objective::Kind::kDistanceToPoint;
  to_p.point = {p[0], p[1], p[2]};
  if (const auto boxes = solver.try_feasible(formula)) {
    const auto best = optimize(*boxes, step, to_p, distance::Sense::kMinimum);
    if (!best.value) return std::nullopt;
    const space::IntervalBox at = best.at.boxes().at(0);  // a point
    return NearestFeasible{distance::coordinates(space::scaled(step, {*at[0].from, *at[1].from, *at[2].from})),
                           *best.value, best.attained};
  }
  const auto convex = solver.feasible_convex(formula);
  if (!convex || !*convex) return std::nullopt;
  const SpaceSolver::ConvexMap& map = **convex;
  const auto best = optimize(map.set, map.step, to_p, distance::Sense::kMinimum);
  if (!best || !best->value) return std::nullopt;
  return NearestFeasible{distance::coordinates(space::scaled(map.step, best->at.region.vertices().front().at)),
                         *best->value, best->attained};
}

}  // namespace findspace::formula
