// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A solid that round ones are cut out of, between two bodies of the cells of a lattice over the box about it: those
// that lie in it, and all but those beside it. Guarantee: exact. Cost: some hundred gaps of a cell and a convex set.
// Keywords: inner and outer approximation, octree.
#pragma once

#include <cstddef>
#include <optional>

#include "space/body/body.h"
#include "space/body/csg_solid.h"

namespace findspace::distance {

struct BodiesOfCells {
  /// No body where there are no cells; `inside` is then a place, where one of the grid is found in the solid.
  std::optional<space::Body> inside, about;
  double filled = 0;  // how much of what holds it lies in it
};
/// `across`: a power of two, of cells along each axis.
BodiesOfCells bodies_of_cells(const space::CsgSolid& solid, std::size_t across);

}  // namespace findspace::distance
