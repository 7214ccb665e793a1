// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The lexicographic minimiser of a list of goals over the positions of one body, for all its allowed angles together
// (distances.md 6.2): minimise the first objective, keep where it is least, go on with the next. A condition "form =
// value" keeps the positions on that line. An objective that is infinite everywhere (a distance that is undefined)
// decides nothing. Tie rule: of the positions that are left the one with the least y, then the least x, at the first of
// the angles that has it; where they have no such position (an open or unbounded set), a point of their first
// component, inside it. With the goal "grid" the nearest grid point of the set within a few steps is taken that keeps
// the conditions (near_grid.h); where there is none the minimiser stays.
// A chain of positions would otherwise have numbers that grow with every body; where a sign about one could need 4096
// bits the grid point is taken without that goal. Guarantee: exact where the objectives are (solve_region.h). Keywords:
// bottom-left, argmin, tie breaking.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planning/order/placement.h"
#include "planning/order/relations.h"

namespace findspace::planning {

/// The positions of a body at one of its angles.
struct AtAngle {
  std::size_t angle = 0;
  plane::Region region;
};

struct Chosen {
  std::optional<Pose> pose;  // none: no position, or no best one where that is wanted
  /// False where there are positions, but none takes the least values: `values` ends with the infimum that none takes.
  bool attained = true;
  /// Of the objectives, in the scene's unit; none: infinite, or a condition.
  std::vector<std::optional<exact::Real>> values;
  bool unbounded = false;  // the last value is -infinity
  bool shortened = false;  // the minimiser's numbers were too long, so the grid point was taken
};

/// `poses`: where the other bodies stand; an objective that speaks of one without a pose decides nothing.
Chosen choose(const Relations& relations, std::size_t body, const std::vector<AtAngle>& all, const Poses& poses,
              Pick pick = Pick::kBest);

/// The positions that keep all conditions on coordinates. Throws Error(kUnsupported) for an unbounded set.
plane::Region keeping_conditions(const Problem& problem, plane::Region positions);

/// The tie rule: a position of the set, none if it is empty.
std::optional<exact::RealPoint> representative(const plane::Region& positions);

}  // namespace findspace::planning
