// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of distances along a direction u (distances.md 7.1; definitions in directional.h), at levels other
// than 0 of gamma1, eta1 and delta1, and at any level of gamma2, eta2 and delta2. The closed sets are unions of convex
// polyhedra: those that the open sets of a cover close to, and what the cover leaves (pieces, facets, edges and single
// points); or, of gamma1 and gamma2 of round bodies, of convex differences grown by their radii. The regions are their
// sums with stretches of a line, with or without its ends (space/rays/swept_pieces.h). Guarantee: exact on every
// line. The depth in a union with round parts, and containment of or in round bodies, are found by values
// (round_directional.h), which says what is refused. Cost: the convex pieces of the sets, each made once. Keywords:
// partial Minkowski sum, directional penetration depth.
#pragma once

#include <memory>

#include "distance/planar/shape_pair.h"
#include "distance/rays/ray_covers.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

/// `which` is one of the six; the level in the bodies' steps. `direction` need not be of length 1.
exact::Tried<space::RaySourcePointer> ray_directional_map(Which which, const exact::Real& level,
                                                          const space::RealVector& direction, bool both_ways,
                                                          const BodiesOnLines& bodies, const space::RayGrid& grid);

}  // namespace findspace::distance
