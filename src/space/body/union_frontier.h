// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The frontier of a union U of open convex polyhedral sets, as closed convex polygons, segments and points: the facets
// of the sets less all sets. Slits, edges and single points that no set covers are among them, so the signed distance
// to U at p is - or + the distance to these pieces (distances.md 3.1). Guarantee: exact; pieces may overlap. Cost: the
// pieces into which the facets are cut, times the sets near each. Keywords: boundary of a union, configuration space
// obstacle.
#pragma once

#include <span>
#include <vector>

#include "space/body/open_union.h"
#include "space/polytope/convex_region.h"
#include "space/polytope/polytope.h"

namespace findspace::space {

/// Within the box. Every set is given by its planes, all < 0.
std::vector<ConvexRegion> cover_frontier(std::span<const std::vector<HalfSpace>> sets, const RealVector& low,
                                         const RealVector& high);

/// Of what all of `kept` have in common, less the open polytopes `taken`, the pieces without interior that its `cells`
/// do not hold: those between faces that lie on each other. Lines and points elsewhere are not looked for.
std::vector<ConvexRegion> thin_pieces(std::span<const Polytope> kept, std::span<const Polytope> taken,
                                      std::span<const ConvexRegion> cells);

/// Adds closed pieces whose union is the region less the open set.
void subtract(ConvexRegion piece, const std::vector<HalfSpace>& set, std::vector<ConvexRegion>& out);

/// What of the box the sets leave complement, as far as it has an interior: closed convex pieces whose interiors do not
/// meet. The box has low <= high.
std::vector<ConvexRegion> complement_pieces(const OpenUnion& cover, const RealVector& low, const RealVector& high);

}  // namespace findspace::space
