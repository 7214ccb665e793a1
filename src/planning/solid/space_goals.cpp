// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "planning/solid/space_goals.h"

#include <algorithm>

#include "findspace/error.h"
#include "planning/order/near_grid.h"

namespace findspace::planning {

using exact::Real;
using formula::Goal;
using formula::Objective;
using space::RealVector;

namespace {

constexpr int kRings = 2;  // of grid points

[[noreturn]] void refuse(const char* what) { throw Error(ErrorCode::kUnsupported, what); }

RealVector axis_form(std::size_t axis) {
  RealVector form;
  form[axis] = Real(1);
  return form;
}

void add_condition(const Goal& goal, const Real& step, SpaceGoals& out) {
  if (!out.all.empty()) refuse("in 3D conditions on coordinates come before the objectives");
  const auto& form = *goal.form;
  if (std::count_if(form.begin(), form.end(), [](const Real& c) { return c.sign() != 0; }) != 1)
    refuse("in 3D a condition is on one coordinate");
  for (std::size_t k = 0; k < 3; ++k) {
    if (form[k].sign() == 0) continue;
    const Real value = *goal.equals / (form[k] * step);
    out.none = out.none || (out.fixed[k] && *out.fixed[k] != value);
    out.fixed[k] = value;
  }
}

SpaceGoal goal_of(const Objective& objective, bool negated, const Real& step) {
  using Kind = Objective::Kind;
  SpaceGoal out;
  if (objective.kind == Kind::kDistance) refuse("an objective that is a distance of shapes is not computed for 3D");
  if (objective.kind == Kind::kDistanceToPoint) {
    if (negated) refuse("the greatest distance to a point is not an objective in 3D");
    out.point.emplace();
    for (std::size_t k = 0; k < 3; ++k) (*out.point)[k] = objective.point.at(k) / step;
    return out;
  }
  out.form = axis_form(objective.kind == Kind::kX ? 0 : objective.kind == Kind::kY ? 1 : 2);
  if (negated) out.form = space::negated(out.form);
  return out;
}

}  // namespace

std::array<RealVector, 3> tie_forms() { return {axis_form(2), axis_form(1), axis_form(0)}; }

void SpaceGoals::put_on_grid(std::optional<RealVector>& at, const std::function<bool(const RealVector&)>& holds) const {
  if (!grid || !at || ((*at)[0].integer() && (*at)[1].integer() && (*at)[2].integer())) return;
  const auto keeps = [&](const RealVector& p) {
    for (std::size_t k = 0; k < 3; ++k)
      if (fixed[k] && p[k] != *fixed[k]) return false;
    return holds(p);
  };
  if (auto found = nearest_on_grid(*at, kRings, keeps)) at = std::move(found);
}

std::optional<std::vector<RealVector>> SpaceGoals::forms() const {
  std::vector<RealVector> out;
  for (const SpaceGoal& g : all) {
    if (g.point) return std::nullopt;
    out.push_back(g.form);
  }
  for (const RealVector& tie : tie_forms()) out.push_back(tie);
  return out;
}

SpaceGoals space_goals(const SpaceProblem& problem, std::size_t body) {
  SpaceGoals out;
  for (const Goal& goal : problem.goals) {
    if (goal.grid) {
      out.grid = true;
    } else if (goal.equals) {
      add_condition(goal, problem.step, out);
    } else if (goal.form) {
      out.all.push_back({{(*goal.form)[0], (*goal.form)[1], (*goal.form)[2]}, std::nullopt});
    } else {
      out.all.push_back(goal_of(*goal.objective, goal.negated, problem.step));
    }
  }
  if (const auto& near = problem.bodies[body].near) {
    out.grid = true;
    out.all.insert(out.all.begin(), {{}, RealVector{(*near)[0], (*near)[1], (*near)[2]}});
  }
  return out;
}

}  // namespace findspace::planning
