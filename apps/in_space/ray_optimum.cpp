// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "in_space/ray_optimum.h"

#include <fmt/format.h>

#include "exact/margins/rounding.h"
#include "formula/solid/optimize_rays.h"

namespace findspace::app {

space::RayAim aim_of(const Session& session, const Session::Goal& goal) {
  using Kind = formula::Objective::Kind;
  space::RayAim aim;
  aim.greatest = goal.sense == distance::Sense::kMaximum;
  const Kind kind = goal.objective.kind;
  if (kind == Kind::kX || kind == Kind::kY || kind == Kind::kZ) {
    aim.axis = kind == Kind::kX ? 0 : kind == Kind::kY ? 1 : 2;
  } else if (kind == Kind::kDistanceToPoint && !aim.greatest) {
    for (std::size_t k = 0; k < 3; ++k) aim.point[k] = (goal.objective.point.at(k) / session.step()).to_double();
  } else {
    throw Error(ErrorCode::kUnsupported, "in 3D the distance to a point can be minimised only", session.scene().file);
  }
  return aim;
}

namespace {

/// What the places on the lines say of the whole region, if the cells about them are on one side of it: a goal changes
/// by no more than the length of a step.
void take_side(const RaySet& set, double step, io::RayOptimum& found) {
  if (set.side == formula::Side::kInner) found.bound.reset();
  if (set.side != formula::Side::kOuter || !found.value) return;
  const double radius = cell_radius(set).to_double() * step * margin::kUpward,
               from = found.bound.value_or(*found.value);
  found.bound = found.maximum ? from + radius : from - radius;
  found.attained = false;
}

}  // namespace

std::optional<io::RayOptimum> best_of(const RaySet& set, Cast& cast, double step) {
  io::RayOptimum out;
  out.maximum = set.objective->greatest != (set.objective->sign < 0);
  if (set.unbounded && set.objective->greatest) return out;
  const auto best = formula::best_on_lines(std::move(cast.intervals), set.objective->greatest, set.objective->value);
  if (!best) return out;
  out.attained = best->attained;
  out.value = best->value * step * set.objective->sign;
  out.bound = best->bound * step * set.objective->sign;
  for (std::size_t k = 0; k < 3; ++k) out.at[k] = best->at[k] * step;
  take_side(set, step, out);
  return out;
}

io::RayOptimum optimum_of(const RaySet& set, const Cast& cast, double step) {
  io::RayOptimum out;
  out.maximum = set.aim->greatest;
  // Of a coordinate there is no bound where the region goes on for ever.
  if (!cast.extreme || (set.unbounded && set.aim->axis >= 0)) return out;
  out.attained = cast.extreme->attained;
  out.value = cast.extreme->value * step;
  for (std::size_t k = 0; k < 3; ++k) out.at[k] = cast.extreme->at[k] * step;
  take_side(set, step, out);
  return out;
}

io::RayOptimum least_of(const formula::LeastOf& found) {
  io::RayOptimum out;
  if (!found.least) return out;
  out.attained = true;
  out.value = found.least->value.to_double();
  if (!found.least->proven) out.bound = found.least->bounds().lower->to_double();
  for (std::size_t k = 0; k < 3; ++k) out.at[k] = found.least->at[k].to_double();
  return out;
}

RayObjective objective_of(const formula::SpaceSolver& solver, const Session::Goal& goal) {
  RayObjective out;
  const bool negated = goal.objective.negated;
  out.sign = negated ? -1 : 1;
  out.greatest = (goal.sense == distance::Sense::kMaximum) != negated;
  const auto at = [&solver, wanted = goal.objective.distance](const std::array<double, 3>& place) {
    space::RealVector p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = exact::Real::from_double(place[k]);
    return solver.value(wanted, p);
  };
  if (!at({})) throw Error(ErrorCode::kUnsupported, "the objective is undefined for these shapes: " + goal.text);
  out.value = [at](const std::array<double, 3>& place) {
    const auto v = at(place);
    return v->minus_infinity ? -exact::kInfinity : v->value.to_double();
  };
  return out;
}

std::string optimum_text(const io::RayOptimum& found, bool on_lines) {
  return fmt::format("  {}{}: {} at ({}, {}, {}){}\n", found.maximum ? "greatest" : "least",
                     on_lines ? " on the lines" : " over all positions", *found.value, found.at[0], found.at[1],
                     found.at[2], found.bound ? fmt::format("; none is beyond {}", *found.bound) : "");
}

}  // namespace findspace::app
