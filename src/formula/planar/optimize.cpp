// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/optimize.h"

#include <limits>

#include "distance/planar/farthest.h"
#include "distance/planar_least/coordinate.h"
#include "distance/planar_least/level_extremum.h"
#include "findspace/error.h"
#include "formula/planar/least_values.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/rotation_values.h"
#include "formula/planar/sums.h"

namespace findspace::formula {

using distance::Sense;
using exact::Real;

namespace {

Sense opposite(Sense s) { return s == Sense::kMinimum ? Sense::kMaximum : Sense::kMinimum; }

/// `unit`: that of the values.
Optimum optimum(distance::Extremum e, const Real& step, bool negated, std::optional<Real> unit_of_values = {}) {
  const Real unit = unit_of_values.value_or(step);
  Optimum out;
  out.unbounded = e.unbounded;
  out.proven = e.proven;
  if (!e.exists) {
    out.at = plane::CellComplex::uniform(0);
    return out;
  }
  out.value = negated ? -(e.level * unit) : e.level * unit;
  out.attained = e.attained;
  out.bound = (negated ? -e.bound : e.bound) * unit.to_double();
  out.within = e.within * step.to_double();
  out.at = std::move(e.at);
  return out;
}

Real unit_of(const Distance& d, const Solver& solver) {
  return d.mode == Mode::kRotation ? Real(1) : solver.world().step;
}

/// The best of the certain positions, and no better than the best of the possible ones.
Optimum between(Optimum certain, const Optimum& possible, Sense sense) {
  const double none =
      sense == Sense::kMinimum ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  const bool exact = certain.value && possible.value && certain.proven && possible.proven &&
                     compare(*certain.value, *possible.value) == 0;
  if (exact || certain.unbounded) return certain;
  const bool empty = !possible.value && !possible.unbounded;
  certain.proven = empty;
  certain.attained = certain.attained && certain.value.has_value();
  certain.within = std::numeric_limits<double>::infinity();
  certain.bound = !possible.value ? none : possible.proven ? possible.value->to_double() : possible.bound;
  return certain;
}

/// The sum is finite, or infinite everywhere.
Optimum best_sum(const distance::PositionBounds& over, const Objective& objective, Sense sense, const Solver& solver) {
  const PreparedWorld& world = solver.prepared();
  const distance::DistanceSum sum = distance_sum(world, objective.terms);
  return optimum(best_position(sum, over, sense, reach_of(world, objective.terms)), world.step(), false);
}

}  // namespace

bool is_bounded(const Objective& objective, const Solver& solver) {
  return objective.kind == Objective::Kind::kDistance && is_bounded(solver.prepared(), objective.distance);
}

Optimum optimize(const RegionBounds& regions, const Objective& objective, Sense sense, const Solver& solver) {
  if (objective.kind == Objective::Kind::kSum)
    return best_sum({regions.inner, regions.outer}, objective, sense, solver);
  if (!is_bounded(objective, solver)) {
    return between(optimize(regions.inner, objective, sense, solver), optimize(regions.outer, objective, sense, solver),
                   sense);
  }
  const Sense of_distance = objective.negated ? opposite(sense) : sense;
  return optimum(best_position(solver.prepared(), objective.distance, {regions.inner, regions.outer}, of_distance),
                 solver.world().step, objective.negated, unit_of(objective.distance, solver));
}

Optimum optimize(const plane::Region& region, const Objective& objective, Sense sense, const Solver& solver) {
  const Real& step = solver.world().step;
  switch (objective.kind) {
    case Objective::Kind::kX:
      return optimum(linear_extremum(region, distance::kX, sense), step, false);
    case Objective::Kind::kY:
      return optimum(linear_extremum(region, distance::kY, sense), step, false);
    case Objective::Kind::kZ:
      throw Error(ErrorCode::kUnsupported, "the objective z needs a scene in three dimensions");
    case Objective::Kind::kDistanceToPoint: {
      auto f = distance::Farthest::from_point({objective.point.at(0) / step, objective.point.at(1) / step});
      return optimum(extremum(f, region, sense), step, false);
    }
    case Objective::Kind::kSum:
      return best_sum({region, region}, objective, sense, solver);
    case Objective::Kind::kDistance:
      break;
  }
  const Sense of_distance = objective.negated ? opposite(sense) : sense;
  if (solver.world().motion.given() || objective.distance.mode != Mode::kPlain) {
    const bool continuous = objective.distance.mode == Mode::kPlain;
    return optimum(
        level_extremum(*position_function(solver.prepared(), objective.distance), region, of_distance, continuous),
        step, objective.negated);
  }
  return optimum(extremum(*objective_distance(solver.prepared(), objective.distance), region, of_distance), step,
                 objective.negated);
}

std::optional<Optimum> minimum_of(const Formula& formula, const Solver& solver) {
  for (const SignMap& m : formula.sign_maps())
    if (m.minimum)
      return optimum(least(solver.prepared(), m.distance), solver.world().step, false, unit_of(m.distance, solver));
  return std::nullopt;
}

}  // namespace findspace::formula
