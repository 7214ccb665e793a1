// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The positions p at which a body B + p and a solid A that convex sets are cut out of have no interior in common, and
// the one nearest to a position: the depth of B in A, and, of the solid that others leave, how far B is from fitting
// among them: a provider of position_set.h. What a part of B has in common with a part of A that nothing is cut out of
// has slack that is concave in p (meet_slack.h), so the boundary search (boundary_search.h) takes it as it is. Else
// each place x of A, with a plane between it and what is cut out, says a convex subset of A, and so a concave function
// below the slack that is the slack itself where x is the deepest place: each cell of the search makes those that it
// needs (LazyConstraints), right to the square of its size. Guarantee: doubles; the place is one at which common slack
// is at most 2^-42 of the sizes, no such position is nearer than `bound`; the search may end before (`complete`), so
// where edges of B lie on edges of what is cut out. Sets cut out may be anything convex; others polytopes and balls.
// Cost: some hundred cells, each some dozen slacks. Keywords: penetration depth, reverse convex programming, cutting
// planes.
#pragma once

#include <vector>

#include "distance/csg/csg_part.h"
#include "distance/search/position_set.h"

namespace findspace::distance {

/// The positions at which B is free of the parts, which have to outlive it. Refused for round polyhedra and for what
/// has no interior.
exact::Tried<PositionSet> free_positions(const space::Body& b, const std::vector<CsgPartSearch>& parts, double size);

}  // namespace findspace::distance
