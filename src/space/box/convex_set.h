// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What one convex set R cuts out of space: its inside, its frontier, or what is outside, any of the three. R is a
// convex polytope of any dimension, or one grown by a ball. Such is every set {distance REL level} whose sublevel set
// is convex and polyhedral or the parallel body of a polytope. Where R has no interior all of R is frontier. Guarantee:
// exact truth values; sizes are the exact ones rounded, areas carry a few roundings, and so do sizes of grown sets
// (Steiner's formula). Keywords: half-space intersection, parallel body, Steiner formula.
#pragma once

#include "space/box/box_summary.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

struct ConvexSet {
  ConvexRegion region;
  bool inside = false, frontier = false, outside = false;
  exact::Real radius{};  // of the ball by which the region is grown
};

/// Topological operations, and the complement.
ConvexSet closure(ConvexSet set);
ConvexSet interior(ConvexSet set);
ConvexSet complement(ConvexSet set);
ConvexSet boundary(const ConvexSet& set);

SpaceSummary summarize(const ConvexSet& set, const exact::Real& step);

}  // namespace findspace::space
