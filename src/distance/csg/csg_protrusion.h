// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a body B + p protrudes from a solid A that round ones are cut out of: the greatest distance of a point of B
// to the nearest place of A. The search is tetrahedral_max_min.h, and what bounds a cell are places of A alone: the
// distance to one of them is convex, nowhere less than that to A, and where it is the nearest place of A it has the
// slope of that, so the bound is off by the square of the cell's size. Such places are found when a cell is first
// looked at (position_set.h), and kept. Guarantee: doubles; no point of B is farther out than `bound`. Values are
// proven to 2^-16 of the sizes, where the limit of cells allows it. Cost: some hundred cells, each a nearest
// place of 0.1 to 3 ms. Keywords: directed Hausdorff distance, branch and bound.
#pragma once

#include <vector>

#include "distance/csg/csg_part.h"
#include "distance/search/solid_protrusion.h"

namespace findspace::distance {

struct CsgProtrusion {
  SolidMaxMin found;
  space::Vector nearest;                // place of A to that point
  const CsgPartSearch* part = nullptr;  // that it belongs to
};

/// Until value and bound are so near.
CsgProtrusion csg_protrusion(const Solids& b, const std::vector<CsgPartSearch>& a, double size, double near);

}  // namespace findspace::distance
