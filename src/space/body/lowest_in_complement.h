// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The lexicographic minimiser of linear forms over what a union of open convex sets leaves of a convex polytope: the
// points x of the polytope that no set holds, with f1(x) least, of these with f2(x) least, and so on. Slits, sheets and
// single points that are left count as bulky parts do. Method: best first over convex pieces by their lexicographically
// least vertex; where a set holds that vertex, the piece is divided into its parts beyond the planes of the set, which
// may be flat. Guarantee: exact. Cost: the pieces looked at, those below the minimiser only; where they are more than a
// question may look at (search_work.h), Error(kUnsupported). Source: branch and bound,
// as farthest_in_complement() in open_union.h. Keywords: bottom-left placement, linear programming over a non-convex
// set.
#pragma once

#include <optional>
#include <span>

#include "space/body/open_union.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

/// A form is its gradient. Where the forms do not decide, any one of the minimisers; nothing where nothing is left.
std::optional<RealVector> lowest_in_complement(const OpenUnion& cover, const ConvexRegion& within,
                                               std::span<const RealVector> forms);

}  // namespace findspace::space
