// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over solids of any shape, on the lines of a grid: each sign map of the formula on rays (space/ray_pair.h,
// space/ray_ball.h), laid over each other line by line, and the formula read off their signs in one pass.
// Known: gamma1 of solids at level 0 and of a ball at any level; eta1 and mu of solids in one solid at level 0 and of a
// ball at levels up to 0; delta1 of one solid at level 0. Others are refused with Error(kUnsupported) and the
// distance's name. Guarantee: exact on every line. Cost: one convolution a pair of solids and axis. Keywords: feasible
// region, configuration space.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "situation/formula.h"
#include "space/ray_map.h"
#include "space/ray_solids.h"

namespace findspace::situation {

struct RayWorld {
  std::map<std::string, std::vector<space::RaySolid>> shapes;
  std::vector<std::string> moving;
  exact::Real step;  // one grid step in the scene's unit
};

/// A box (grid steps) beyond which no sign of the formula changes.
struct RayWindow {
  space::Point low, high;
};
RayWindow window(const RayWorld& world, const Formula& formula);

/// -1 where the formula holds, +1 elsewhere. Keeps a reference to the formula.
std::unique_ptr<space::RaySource> ray_region(const RayWorld& world, const Formula& formula, const space::RayGrid& grid);

/// Whether the formula holds far away.
bool holds_far_away(const Formula& formula);

}  // namespace findspace::situation
