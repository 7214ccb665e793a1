// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/solve.h"

#include "formula/planar/instants.h"
#include "formula/planar/measure.h"
#include "formula/planar/nearest_feasible.h"
#include "formula/planar/position_check.h"
#include "formula/planar/regions.h"
#include "formula/planar/rotation_values.h"
#include "formula/planar/solve_rotation.h"
#include "formula/planar/sums.h"
#include "formula/planar/swing.h"

namespace findspace::formula {

using exact::RealPoint;

plane::Region Solver::feasible(const Formula& formula) const { return formula::feasible(prepared_, formula); }

RegionBounds Solver::feasible_bounds(const Formula& formula) const {
  return has_sums(formula) ? sum_region_bounds(*this, formula) : formula::feasible_bounds(prepared_, formula);
}

bool Solver::known_between_bounds(const Formula& formula) const {
  return has_sums(formula) || formula::rotations_in(prepared_, formula);
}

bool Solver::upright(const Formula& formula) const { return !world().motion.given() && has_rotations(formula); }

Check Solver::check(const Formula& formula, const RealPoint& p) const {
  if (upright(formula)) return RotationSolver(*this, {p, {}, {}}).check(formula);
  return check_at(prepared_, formula, prepared_.steps(p));
}

bool Solver::holds(const Formula& formula, const RealPoint& p) const {
  if (upright(formula)) return check(formula, p).holds;
  return holds_at(prepared_, formula, prepared_.steps(p));
}

DistanceAt Solver::distance_at(const Distance& wanted, const RealPoint& p) const {
  const Formula atom(compare(wanted, Relation::kGreaterEqual, exact::Real()));
  if (upright(atom)) return check(atom, p).atoms.front().distance;
  return formula::distance_at(prepared_, wanted, prepared_.steps(p));
}

std::vector<DistanceAt> Solver::measure(const RealPoint& p, const Formula& formula, const WantedText& wanted) const {
  return measure_at(prepared_, prepared_.steps(p), formula, wanted);
}

TriedNearest Solver::nearest_feasible(const Formula& formula, const RealPoint& p) const {
  return nearest_feasible_to(prepared_, formula, prepared_.steps(p));
}

plane::Section Solver::instants(const Formula& formula, const RealPoint& p) const {
  return instants_at(prepared_, formula, prepared_.steps(p));
}

InstantBounds Solver::instant_bounds(const Formula& formula, const RealPoint& p) const {
  return instant_bounds_at(prepared_, formula, prepared_.steps(p));
}

std::optional<plane::Section> Solver::swing(const Formula& formula, const RealPoint& p) const {
  return swing_at(prepared_, formula, prepared_.steps(p));
}

SolvedInstants Solver::solve_instants(const Formula& formula, const RealPoint& p) const {
  if (!known_between_bounds(formula)) return {instants(formula, p), std::nullopt};
  if (std::optional<plane::Section> exact = swing(formula, p)) return {*std::move(exact), std::nullopt};
  InstantBounds bounds = instant_bounds(formula, p);
  return {std::move(bounds.inner), std::move(bounds.outer)};
}

}  // namespace findspace::formula
