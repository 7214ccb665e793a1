// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The placement of several bodies in space: as problem.h in the plane, with solids. Bodies turn about the z axis
// through their poles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formula/solid/solve_space.h"
#include "planning/order/problem.h"

namespace findspace::planning {

struct SpaceProblem : Demands {
  /// Every shape, and every rotated one, by its name; and the same as sets and bodies.
  std::map<std::string, plane::ShapePtr> shapes;
  std::map<std::string, formula::SpaceShape> built;
  exact::Real step;  // one grid step in the scene's unit
  int lines = 128;   // each way, where positions are taken on lines
};

using SpacePose = PoseOf<space::RealVector>;
using SpacePoses = PosesOf<space::RealVector>;

}  // namespace findspace::planning
