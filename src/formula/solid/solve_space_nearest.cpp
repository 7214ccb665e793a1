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

namespace {

/// What `find` gives; nothing where that is refused.
template <class Find>
auto unless_refused(Find find) -> decltype(find()) {
  try {
    return find();
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    return std::nullopt;
  }
}

}  // namespace

std::optional<SpaceNearest> SpaceSolver::nearest_feasible(const Formula& formula, const RealVector& p) const {
  Objective to_p;
  to_p.kind = Objective::Kind::kDistanceToPoint;
  to_p.point = {p[0], p[1], p[2]};
  if (const auto boxes = unless_refused([&] { return std::optional(feasible(formula)); })) {
    const SpaceOptimum best = optimize(*boxes, to_p, distance::Sense::kMinimum);
    if (!best.value) return std::nullopt;
    const space::IntervalBox at = best.at.boxes().at(0);  // a point
    return SpaceNearest{space::scaled(world_.step, {*at[0].from, *at[1].from, *at[2].from}), *best.value,
                        best.attained};
  }
  return unless_refused([&]() -> std::optional<SpaceNearest> {
    const auto convex = feasible_convex(formula);
    if (!convex) return std::nullopt;
    const auto best = formula::optimize(convex->set, convex->step, to_p, distance::Sense::kMinimum);
    if (!best || !best->value) return std::nullopt;
    return SpaceNearest{space::scaled(convex->step, best->at.region.vertices().front().at), *best->value,
                        best->attained};
  });
}

}  // namespace findspace::formula
