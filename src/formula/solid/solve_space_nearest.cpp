// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SpaceSolver: the nearest feasible position, where the region is made of boxes or is one convex polytope. Exact.
#include "findspace/error.h"
#include "formula/solid/optimize_convex.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

using exact::Real;
using space::RealVector;

std::optional<SpaceNearest> SpaceSolver::nearest_feasible(const Formula& formula, const RealVector& p) const {
  Objective to_p;
  to_p.kind = Objective::Kind::kDistanceToPoint;
  to_p.point = {p[0], p[1], p[2]};
  if (const auto boxes = try_feasible(formula)) {
    const SpaceOptimum best = optimize(*boxes, to_p, distance::Sense::kMinimum);
    if (!best.value) return std::nullopt;
    const space::IntervalBox at = best.at.boxes().at(0);  // a point
    return SpaceNearest{space::scaled(world_.step, {*at[0].from, *at[1].from, *at[2].from}), *best.value,
                        best.attained};
  }
  const auto convex = feasible_convex(formula);
  if (!convex || !*convex) return std::nullopt;
  const ConvexMap& map = **convex;
  const auto best = formula::optimize(map.set, map.step, to_p, distance::Sense::kMinimum);
  if (!best || !best->value) return std::nullopt;
  return SpaceNearest{space::scaled(map.step, best->at.region.vertices().front().at), *best->value, best->attained};
}

}  // namespace findspace::formula
