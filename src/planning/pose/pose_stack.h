// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where can it go at which angle? The exact map of positions at each of some angles, and for the sector between two
// neighbouring angles two certified regions: `inner`, positions where the formula holds at every angle of the sector,
// and `outer`, which contains every position where it holds at some.
//
// Method: from the nearer end of the sector no point of the moving shape travels further than
//     bound = R * (half the sector) + what putting vertices on the grid moved,   R the greatest distance from the pole,
// so the shape at any angle of that half contains the shape at the end eroded by the bound, and lies in the shape grown
// by it. gamma1 between levels >= 0, gamma2, mu (for eta1 <= 0 too), ... change by at most the bound and get it added
// to their level; where that is not so (a depth jumps: an exact fit in a slot is lost at once), an eroded or grown
// shape takes a shape's place. Guarantee: maps exact for the rotated shapes on the grid, or between bounds where
// Solver::known_between_bounds(); sectors certified for the exactly rotated shape. Atoms of which nothing certain is
// known (eta2, delta2, along a direction, in rotation but at level 0, sums) make `inner` smaller and `outer` larger,
// never wrong. Cost: one map an angle, two a sector's half. Keywords: configuration space slices, orientation,
// conservative approximation.
#pragma once

#include <optional>
#include <vector>

#include "formula/planar/solve.h"
#include "plane/build/transform.h"

namespace findspace::planning {

struct PoseSlice {
  exact::Real degrees;
  plane::Region region;                // in grid steps; with `outer` the positions that certainly belong
  std::optional<plane::Region> outer;  // of distances in rotation at levels other than 0: those that possibly do
  plane::Rounding rounding;
};

struct PoseSector {
  exact::Real from, to;  // degrees, from < to
  double bound = 0;      // how far a point of the shape can be from where the nearer end has it, in the scene's unit
  plane::Region inner, outer;
};

struct PoseStack {
  std::vector<PoseSlice> slices;    // by angle in [0, 360)
  std::vector<PoseSector> sectors;  // between neighbours at most 180 degrees apart; the last may go across 360
};

/// `about`: the pole, a grid point of the moving shape's own coordinates. Throws Error(kUnsupported) for `-> min` and
/// for distances over time.
PoseStack pose_stack(const formula::World& world, const formula::Formula& formula, const plane::GridPoint& about,
                     std::vector<exact::Real> degrees);

}  // namespace findspace::planning
