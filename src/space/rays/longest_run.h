// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The longest open stretches of a direction that meet none of some closed convex pieces, between two of them. Seen from
// a facet where stretches start, what a piece hides is the piece swept along the direction, a convex set: so the places
// where stretches end are what these sets leave of a column over the facet, and the one farthest from the facet's plane
// is found by branch and bound over convex parts of the column. Parts without interior do not count: their stretches
// are no longer than near ones. Guarantee: exact. The length is a supremum; whether a stretch has it is decided where
// the longest are at single lines or in a plane, else such a stretch is looked for among many. Cost: for each start the
// pieces over it. Keywords: longest chord, free run, visibility, branch and bound.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "space/polytope/convex_region.h"

namespace findspace::space {

/// A polygon from which stretches go to where the plane, which holds it, is positive; the direction does so.
struct RunStart {
  ConvexRegion facet;
  HalfSpace plane;
};

struct LongestRun {
  exact::Real length;                // in lengths of the direction
  std::optional<RealVector> middle;  // of a stretch that is as long
};

/// The box holds all pieces, and over each start there is one. Nothing where no stretch starts.
std::optional<LongestRun> longest_run(std::span<const ConvexRegion> pieces, std::span<const RunStart> starts,
                                      const RealVector& direction, const RealVector& low, const RealVector& high);

}  // namespace findspace::space
