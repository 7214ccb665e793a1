// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps of the T-distances of a moving body B and a fixed body A of space on the lines of a grid, at any level. The
// sets behind the signed distances (distances.md 1.3, 1.4) are unions U of open convex polyhedra (position_covers.h);
//   gamma1 - l   l >= 0: the union of the convex differences grown by l;  l < 0: inside U, the distance to its
//                frontier (cover_frontier.h) against -l;
//   eta1, delta1 minus the signed distance to the union that is the complement of E, D;
//   mu           to a convex A: over all vertices of B; not above 0 it is eta1; above it, and in unions of round parts
//                at 0, by search (protrusion_rays.h);
//   gamma2, eta2, delta2, diameter   intersections of balls about the farthest candidates;  d1, h, dstar, penetration
//   from these. Guarantee: exact on every line, round boundaries included, but where the frontier itself is round and
//   has to
// be measured from: the depth in a union of round parts, containment in such but at level 0, levels above 0 of
// containment of round shapes in shapes that are not convex, of mu of them and of mu to a complement; these are by
// values (value_rays.h). Cost: line_pieces.h for each piece of the sets or of their frontier. Keywords: ray map,
// offset, level set.
#pragma once

#include <memory>

#include "distance/planar/shape_pair.h"
#include "space/body/body.h"
#include "space/rays/ray_map.h"

namespace findspace::distance {

/// Both bodies of one scale, B not `outside`; the level in their steps, the grid in grid steps.
std::unique_ptr<space::RaySource> ray_sign_map(Which which, const exact::Real& level, const space::Body& b,
                                               const space::Body& a, const space::RayGrid& grid);

}  // namespace findspace::distance
