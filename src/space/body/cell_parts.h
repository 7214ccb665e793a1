// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Cells of a partition of space as polytopes: on the grid, on one so much finer that all their vertices are whole, or
// else with vertices rounded once and counted (convex_parts.h). Where nothing was rounded, neighbours whose union is
// convex are joined. Guarantee: exact but for what is counted. Cost: the pairs of cells, for joining.
#pragma once

#include "space/body/convex_parts.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

ConvexParts parts_of_cells(const std::vector<ConvexRegion>& cells);
/// The same of cells that are given by their vertices.
ConvexParts parts_of_corners(const std::vector<std::vector<RealVector>>& cells);

exact::Real six_volumes(const Polytope& p);
/// Rounded.
double surface_area(const Polytope& p);

}  // namespace findspace::space
