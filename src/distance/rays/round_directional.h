// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of distances along a direction u of round bodies where the sets to be swept have round boundaries
// that are not convex: with w the least of the convex distances to the open sets (of U, or of the complement of E),
// less their radii,
//   gamma1 < -t   where w < 0 on all of p + [-t, t] u;       eta1 < -t   where w > 0 on all of it;
//   eta1 <= t     where w >= 0 somewhere on it;              eta2        from that and what lies farther off.
// In a convex round A the greatest distance of B's corners takes the place of -w. On stretches these extremes
// change by no more than the length of a step of p, so value_rays.h tells their signs on lines.
// Guarantee: as there: 0 within 2^-30 of the sizes. Refused where A is a union of round parts, and where fits
// of zero clearance leave no sign. Cost: as value_rays.h. Source: distances.md 7.1. Keywords: directional
// penetration depth, partial Minkowski sum.
#pragma once

#include <memory>

#include "distance/planar/shape_pair.h"
#include "space/body/body.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

/// As of ray_directional_map, the vector of length 1.
struct DirectionalQuery {
  space::RealVector unit;
  bool both_ways = true;
  bool farthest = false;  // eta2
};

/// gamma1 at a level below 0 of bounded bodies.
std::unique_ptr<space::RaySource> round_depth_map(const exact::Real& level, const DirectionalQuery& query,
                                                  const space::Body& b, const space::Body& a,
                                                  const space::RayGrid& grid);
/// eta1 at a level other than 0, or eta2; bounded bodies, one of them round.
exact::Tried<space::RaySourcePointer> round_fit_map(const exact::Real& level, const DirectionalQuery& query,
                                                    const space::Body& b, const space::Body& a,
                                                    const space::RayGrid& grid);

}  // namespace findspace::distance
