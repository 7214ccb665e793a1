// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What one convex polytope R (of any dimension) cuts out of space: its inside, its frontier, or what is outside, any of
// the three. Such is every set {distance REL level} whose sublevel set is convex and polyhedral. Where R has no
// interior all of R is frontier. Guarantee: exact truth values; sizes are the exact ones rounded, areas carry a few
// roundings. Keywords: half-space intersection.
#pragma once

#include "space/box_summary.h"
#include "space/convex_region.h"

namespace findspace::space {

struct ConvexSet {
  ConvexRegion region;
  bool inside = false, frontier = false, outside = false;
};

SpaceSummary summarize(const ConvexSet& set, const exact::Real& step);

}  // namespace findspace::space
