// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value over all positions of gamma1, eta1 or delta1 along a direction (distances.md 7.1): minus the longest
// stretch of the direction in U, int E or int D, or half of it where B may go both ways. Where that is empty it is 0,
// at contact. One way only no position takes it, as a stretch ends in contact; both ways perhaps none either, where the
// longest stretches are met by a corner from aside. Of polyhedra the stretches run between the frontier of U, or
// between the closed sets of positions at which B is not in A (space/rays/longest_run.h); one convex set is its longest
// chord, grown by a ball where shapes are round. Guarantee: exact. Unions of round parts, and other shapes in round
// ones, are enclosed (round_runs.h, swept_fits.h). Refused: complements, over whose positions there is none. Keywords:
// directional penetration depth, longest chord.
#pragma once

#include "distance/answer/answer.h"
#include "distance/planar/shape_pair.h"
#include "space/body/body.h"

namespace findspace::distance {

/// Of a least value.
inline bool is_taken(const Answer& least) { return least.side != Side::kNone; }

/// Of bodies of one scale, B not `outside`; `direction` need not be of length 1. Nothing where the distance is
/// undefined. Of an infimum, which no position takes, the side is kNone, and `at` says nothing.
TriedAnswer ray_directional_least(Which which, const space::RealVector& direction, bool both_ways, const space::Body& b,
                                  const space::Body& a);

/// The same of positions that are a convex polytope, perhaps grown by a ball.
std::optional<Answer> convex_directional_least(const space::ConvexRegion& positions, const exact::Real& radius,
                                               const space::RealVector& direction, bool both_ways);

}  // namespace findspace::distance
