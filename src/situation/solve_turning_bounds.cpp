// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// TurnSolver where angles are known between bounds only: distances in rotation about another point than the moving
// shape turns about, at levels other than 0 (turning_angles.h).

#include <algorithm>

#include "distance/turning_angles.h"
#include "situation/evaluate.h"
#include "situation/solve_turning.h"
#include "situation/which.h"

namespace findspace::situation {

using exact::RealPoint;
using plane::Mark;
using plane::TurnMap;

bool TurnSolver::turns_twice(const Formula& formula) const {
  about_ = centre(formula);
  const auto& maps = formula.sign_maps();
  return std::any_of(maps.begin(), maps.end(), [&](const SignMap& m) { return turns_twice(m); });
}

distance::BoundedTurns TurnSolver::bounded_map(const SignMap& wanted) const {
  if (!turns_twice(wanted) || wanted.minimum) {
    TurnMap exact = sign_map(wanted);
    return {exact, exact};
  }
  const exact::Real& step = solver_.world().step;
  const Distance d = moving_first(wanted.distance, solver_.world().moving);
  const plane::Region b = solver_.shape(d.first), a = solver_.shape(d.second);
  const RealPoint to{about_.x + pose_.at.x / step, about_.y + pose_.at.y / step};
  const RealPoint centre{d.vector.at(0) / step, d.vector.at(1) / step};
  return distance::turning_angle_maps({b, a, about_, to}, solver_.which(d), centre, wanted.level);
}

TurnSolver::Bounds TurnSolver::feasible_bounds(const Formula& formula) const {
  about_ = centre(formula);
  std::vector<distance::BoundedTurns> maps;
  for (const SignMap& m : formula.sign_maps()) maps.push_back(bounded_map(m));
  std::vector<const TurnMap*> operands;
  for (const auto& m : maps) operands.insert(operands.end(), {&m.low, &m.high});
  const TurnMap both = plane::overlay(operands, [&](std::span<const Mark> marks) { return certainty(formula, marks); });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

}  // namespace findspace::situation
