// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The shapes that formulas of the plane speak of, where they are given, and how they move. Keywords: scene, workspace.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formula/planar/motion.h"
#include "formula/planar/witness.h"

namespace findspace::formula {

struct World {
  Shapes shapes;  // in grid steps
  std::vector<std::string> moving;
  exact::Real step;                    // one grid step in the scene's unit
  Motion motion;                       // if given, distances are taken over its time
  std::optional<exact::Real> instant;  // of the motion: distances without inf and sup are those of this time
  Parts parts;                         // of the shapes that are collections, for reports
  bool eroded = false;                 // shapes made smaller by the program: nothing may be left of one
};

}  // namespace findspace::formula
