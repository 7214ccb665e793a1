// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The best position of a placement in space over a set given on rays. Grid points only: of those on N x N lines along z
// the best one; from there the best one on the line along each axis through it, and on N lines in each plane through
// it that is normal to an axis, again and again while that gets better. Guarantee: the position is a grid point and
// belongs to the set, exactly; on no line along an axis through it is there a better grid point. Elsewhere there may
// be. Cost: the lines, and a few more for each step. Keywords: coordinate descent, bottom-left placement.
#pragma once

#include <functional>

#include "planning/solid/space_goals.h"
#include "space/rays/ray_sources.h"

namespace findspace::planning {

struct LinesAsked {
  std::function<space::RaySourcePointer(const space::RayGrid&)> source;  // at most 0 in the set
  space::Point low, high;                                                // the lines cover this box
  int count = 0;                                                         // lines each way
};

SpaceBest best_on_lines(const LinesAsked& lines, const SpaceGoals& goals);

}  // namespace findspace::planning
