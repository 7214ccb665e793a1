// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SpaceSolver: the nearest feasible position, where the region is made of boxes or is one convex polytope. Exact.
#include "findspace/error.h"
#include "situation/optimize_convex.h"
#include "situation/solve_space.h"

namespace findspace::situation {

using exact::Real;
using space::RealVector;

std::optional<SpaceNearest> SpaceSolver::nearest_feasible(const Formula& formula, const RealVector& p) const {
  Objective to_p;
  to_p.kind = Objective::Kind::kDistanceToPoint;
  to_p.point = {p[0], p[1], p[2]};
  try {
    if (axis_parallel()) {
      const SpaceOptimum best = optimize(feasible(formula), to_p, distance::Sense::kMinimum);
      if (!best.value) return std::nullopt;
      const space::IntervalBox at = best.at.boxes().at(0);  // a point
      return SpaceNearest{space::scaled(world_.step, {*at[0].from, *at[1].from, *at[2].from}), *best.value,
                          best.attained};
    }
    const auto convex = feasible_convex(formula);
    const auto best =
        convex ? situation::optimize(convex->set, convex->step, to_p, distance::Sense::kMinimum) : std::nullopt;
    if (!best || !best->value) return std::nullopt;
    return SpaceNearest{space::scaled(convex->step, best->at.region.vertices().front().at), *best->value,
                        best->attained};
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    return std::nullopt;
  }
}

}  // namespace findspace::situation
