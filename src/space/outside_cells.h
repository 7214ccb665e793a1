// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex sets whose union is the closure of the complement of a body whose parts have no radius (a single one may be
// flat). The first ones are half spaces; the others, cells of the bounding box, do not meet in their interiors.
// Guarantee: exact. Cost: a cell of the box is cut by every part it overlaps. Keywords: complement, convex
// decomposition.
#pragma once

#include <vector>

#include "space/body.h"
#include "space/real_vector.h"

namespace findspace::space {

struct OutsideCell {
  std::vector<HalfSpace> planes;       // all <= 0
  std::vector<RealVector> vertices;    // none for a half space
  std::vector<RealVector> directions;  // of its edges
};
std::vector<OutsideCell> outside_cells(const Body& body);

}  // namespace findspace::space
