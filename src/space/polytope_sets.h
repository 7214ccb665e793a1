// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Intersection and difference of finite unions of convex polytopes, as convex cells.
//   intersection_cells   the parts of A n B with interior; Error(kUnsupported) if a thin piece (the two touch) is left
//   over, since a body
//                        has none;
//   difference_cells     the closure of A \ B; its cells do not overlap where those of A do not.
// Guarantee: exact: a cell is kept if and only if it has interior. Cost: cells times facets.
// Keywords: constructive solid geometry, convex clipping.
#pragma once

#include <span>
#include <vector>

#include "space/convex_region.h"
#include "space/polytope.h"

namespace findspace::space {

std::vector<ConvexRegion> intersection_cells(std::span<const Polytope> a, std::span<const Polytope> b);
std::vector<ConvexRegion> difference_cells(std::span<const Polytope> a, std::span<const Polytope> b);

}  // namespace findspace::space
