// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Intersection and difference of finite unions of convex polytopes, as convex cells.
//   intersection_cells   A n B;
//   difference_cells     the closure of A \ B; its cells do not overlap where those of A do not;
//   outside_cells        A \ int B, of all of B: walls between its polytopes are in the interior.
// Guarantee: exact: a cell is kept if and only if it has interior. A refusal says that a thin piece is left over (A
// and B touch, faces of A and int B lie on each other), since a body has none. Cost: cells times facets.
// Keywords: constructive solid geometry, convex clipping.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "exact/number/tried.h"
#include "space/polytope/convex_region.h"
#include "space/polytope/polytope.h"

namespace findspace::space {

/// Thin pieces are left out where `beside` covers them.
exact::Tried<std::vector<ConvexRegion>> intersection_cells(std::span<const Polytope> a, std::span<const Polytope> b,
                                                           std::span<const Polytope> beside = {});
std::vector<ConvexRegion> difference_cells(std::span<const Polytope> a, std::span<const Polytope> b);
exact::Tried<std::vector<ConvexRegion>> outside_cells(std::span<const Polytope> a, std::span<const Polytope> b,
                                                      std::span<const Polytope> beside = {});
/// Says that a shape, `of`, has a thin piece.
exact::Refusal thin_part(const std::string& of);
/// What all have in common.
ConvexRegion common_region(std::span<const Polytope> polytopes);
/// Pieces of a region without interior that hold all of it that is not in the others, and may hold more; none where it
/// lies in their union.
std::vector<ConvexRegion> uncovered(const ConvexRegion& thin, std::span<const ConvexRegion> by);
/// Six times the volume of the union.
exact::Real six_volumes_of_union(std::span<const Polytope> polytopes);

}  // namespace findspace::space
