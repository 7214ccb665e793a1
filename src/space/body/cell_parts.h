// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Cells of a partition of space as polytopes: on the grid, on one so much finer that all their vertices are whole, or
// else with vertices rounded once and counted (convex_parts.h). Where nothing was rounded, neighbours whose union is
// convex are joined. Guarantee: exact but for what is counted. Cost: the pairs of cells, for joining. A cell that
// rounding makes flat is left out: of a mesh, and else where the others hold what it is then.
#pragma once

#include <findspace/error.h>

#include "space/body/convex_parts.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

/// Of the vertices of each.
using CellCorners = std::vector<std::vector<RealVector>>;
CellCorners cell_corners(const std::vector<ConvexRegion>& cells);

/// Of a mesh, whose volume is compared.
ConvexParts parts_of_cells(const std::vector<ConvexRegion>& cells);
/// Of cells with interior, of which none is lost: vertices are rounded to as fine a grid as that takes. Refuses cells
/// that are too thin for any.
exact::Tried<ConvexParts> all_parts(const CellCorners& cells);

/// With vertices in steps / scale, rounded and counted where they are not whole; neighbours are not joined. Refuses as
/// all_parts(), for this one grid.
exact::Tried<ConvexParts> rounded_corners(const CellCorners& cells, std::int64_t scale);

/// Where steps so fine would take coordinates out of the range.
Error too_fine();
/// The least common multiple; throws too_fine() beyond 2^40.
std::int64_t joint_scale(std::int64_t a, std::int64_t b);

exact::Real six_volumes(const Polytope& p);
/// Rounded.
double surface_area(const Polytope& p);

}  // namespace findspace::space
