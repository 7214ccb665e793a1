// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The objectives of a placement in space, as its three algorithms take them: linear forms of the position and
// distances to points, the first first; before them, coordinates that must have a value. What the objectives leave open
// is decided by the least z, then y, then x.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "planning/solid/space_problem.h"

namespace findspace::planning {

struct SpaceGoal {
  space::RealVector form{};                // least where this form is ...
  std::optional<space::RealVector> point;  // ... or the distance to this point; in grid steps
};

struct SpaceGoals {
  std::array<std::optional<exact::Real>, 3> fixed;  // in grid steps
  bool none = false;                                // two conditions contradict each other
  std::vector<SpaceGoal> all;
  bool grid = false;

  bool has_fixed() const { return none || fixed[0] || fixed[1] || fixed[2]; }
  /// Where "grid" is wanted: to the nearest grid point within a few steps that holds(p) and keeps what is fixed, if
  /// there is one.
  void put_on_grid(std::optional<space::RealVector>& at,
                   const std::function<bool(const space::RealVector&)>& holds) const;
  /// The goals and the rule for ties, where all are forms.
  std::optional<std::vector<space::RealVector>> forms() const;
};

/// z, y, x.
std::array<space::RealVector, 3> tie_forms();

/// Throws Error(kUnsupported) for objectives that are distances of shapes, for greatest distances to a point, and for
/// conditions on more than one coordinate or after an objective.
SpaceGoals space_goals(const SpaceProblem& problem, std::size_t body);

/// The best position of a body in one of its sets of positions.
struct SpaceBest {
  std::optional<space::RealVector> at;  // in grid steps
  bool attained = true;                 // false: there are positions, but none takes the least values
  bool unbounded = false;               // the last value is -infinity
  bool on_lines = false;                // between the lines there may be better ones (or some, where there is none)
  std::vector<std::optional<exact::Real>> values;  // of the objectives, in the scene's unit; none: a condition
};

}  // namespace findspace::planning
