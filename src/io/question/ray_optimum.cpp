// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <findspace/error.h>
#include <fmt/format.h>

#include "formula/solid/optimize_rays.h"
#include "io/question/ray_set.h"

namespace findspace::io {

space::RayAim aim_of(const AskedScene& asked, const AskedScene::Goal& goal) {
  using Kind = formula::Objective::Kind;
  space::RayAim aim;
  aim.greatest = goal.sense == distance::Sense::kMaximum;
  const Kind kind = goal.objective.kind;
  if (kind == Kind::kX || kind == Kind::kY || kind == Kind::kZ) {
    aim.axis = kind == Kind::kX ? 0 : kind == Kind::kY ? 1 : 2;
  } else if (kind == Kind::kDistanceToPoint && !aim.greatest) {
    for (std::size_t k = 0; k < 3; ++k) aim.point[k] = (goal.objective.point.at(k) / asked.step()).to_double();
  } else {
    throw Error(ErrorCode::kUnsupported, "in 3D the distance to a point can be minimised only", asked.scene().file);
  }
  return aim;
}

namespace {

formula::LinesOfRegion lines_of(const RaySet& set, const Cast& cast) {
  return {cast.on_lines, set.side, cell_radius(set)};
}

distance::OptimalValue none(distance::Sense sense) {
  distance::OptimalValue out;
  out.sense = sense;
  return out;
}

}  // namespace

distance::OptimalValue best_of(const RaySet& set, Cast& cast, double step) {
  const RayObjective& objective = *set.objective;
  const auto sense = objective.greatest != (objective.sign < 0) ? distance::Sense::kMaximum : distance::Sense::kMinimum;
  if (set.unbounded && objective.greatest) return none(sense);
  auto best = formula::best_on_lines(std::move(cast.intervals), objective.greatest, objective.value);
  if (!best) return none(sense);
  best->value *= objective.sign;
  best->bound *= objective.sign;
  return formula::best_over_region(*best, sense, lines_of(set, cast), step);
}

distance::OptimalValue optimum_of(const RaySet& set, const Cast& cast, double step) {
  const auto sense = set.aim->greatest ? distance::Sense::kMaximum : distance::Sense::kMinimum;
  // Of a coordinate there is no bound where the region goes on for ever.
  if (!cast.extreme || (set.unbounded && set.aim->axis >= 0)) return none(sense);
  const auto& found = *cast.extreme;
  return formula::best_over_region({found.value, found.value, found.at, found.attained}, sense, lines_of(set, cast),
                                   step);
}

distance::OptimalValue least_of(const formula::LeastOf& found) {
  distance::OptimalValue out;
  if (found.least) out.set_found(in_scene(*found.least, exact::Real(1)));
  return out;
}

RayObjective objective_of(const formula::SpaceSolver& solver, const AskedScene::Goal& goal) {
  if (goal.objective.distance.mode != formula::Mode::kPlain)  // it jumps, and is undefined at some positions
    throw Error(ErrorCode::kUnsupported, "in 3D a distance along a direction is no objective: " + goal.text);
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

std::string ray_optimum_text(const distance::OptimalValue& found) {
  const bool on_lines = found.answer->way == distance::Way::kLines;
  const auto at = [&](std::size_t k) { return found.answer->at.at(k).to_double(); };
  const auto bound = found.bound();
  if (found.answer->at.empty()) {
    return fmt::format("  least over all positions: {}, which no position takes{}\n", found.value()->to_double(),
                       bound ? fmt::format("; none is beyond {}", bound->to_double()) : "");
  }
  return fmt::format("  {}{}: {} at ({}, {}, {}){}\n", found.maximum() ? "greatest" : "least",
                     on_lines ? " on the lines" : " over all positions", found.value()->to_double(), at(0), at(1),
                     at(2), bound ? fmt::format("; none is beyond {}", bound->to_double()) : "");
}

}  // namespace findspace::io
