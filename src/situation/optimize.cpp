// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/optimize.h"

#include "distance/coordinate.h"
#include "distance/farthest.h"
#include "distance/level_extremum.h"
#include "findspace/error.h"

namespace findspace::situation {

using distance::Sense;
using exact::Real;

namespace {

Sense opposite(Sense s) { return s == Sense::kMinimum ? Sense::kMaximum : Sense::kMinimum; }

Optimum optimum(distance::Extremum e, const Real& step, bool negated) {
  Optimum out;
  out.unbounded = e.unbounded;
  if (!e.exists) {
    out.at = plane::CellComplex::uniform(0);
    return out;
  }
  out.value = negated ? -(e.level * step) : e.level * step;
  out.attained = e.attained, out.proven = e.proven;
  const double unit = step.to_double();
  out.bound = (negated ? -e.bound : e.bound) * unit, out.within = e.within * unit;
  out.at = std::move(e.at);
  return out;
}

}  // namespace

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
    case Objective::Kind::kDistance:
      break;
  }
  const Sense of_distance = objective.negated ? opposite(sense) : sense;
  if (solver.world().motion.given() || objective.distance.mode != Mode::kPlain) {
    const bool continuous = objective.distance.mode == Mode::kPlain;
    return optimum(level_extremum(*solver.function(objective.distance), region, of_distance, continuous), step,
                   objective.negated);
  }
  return optimum(extremum(*solver.distance(objective.distance), region, of_distance), step, objective.negated);
}

std::optional<Optimum> minimum_of(const Formula& formula, const Solver& solver) {
  for (const SignMap& m : formula.sign_maps())
    if (m.minimum) return optimum(solver.least(m.distance), solver.world().step, false);
  return std::nullopt;
}

}  // namespace findspace::situation
