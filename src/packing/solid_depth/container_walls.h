// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What lies about the inside of a container that is no box, as convex sets for the search: of a convex inside the
// half-spaces beyond its facets, of any other the cells of its box that it leaves empty. About a ball each part has
// half-spaces of its own (ball_walls.h). A part never leaves the box. So walls along its faces are left out, and a cell
// is open where it ends at one of them: its depth leads inwards. Guarantee: corners of cells that are off the grid are
// rounded to doubles; proofs are those of solid_containment.h. Cost: that of outside_cells.h. Keywords: complement,
// container loading, irregular container.
#pragma once

#include <vector>

#include "packing/solid_depth/convex_overlap.h"

namespace findspace::packing {

struct ContainerWalls {
  /// normal . x + offset <= 0 is outside, in units; the normal has length 1.
  struct Plane {
    Vector normal;
    double offset;
  };
  struct Cell {
    space::Body body;  // of one part
    OpenSides open;
  };
  struct Ball {
    Vector center;  // in units
    double radius;
  };
  std::vector<Plane> planes;
  std::vector<Cell> cells;
  std::vector<Ball> balls;  // that hold all
};

/// Of one with an inside.
ContainerWalls container_walls(const SolidProblem& problem, const SolidContainer& container);

}  // namespace findspace::packing
