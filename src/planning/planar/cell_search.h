// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The projections of a pair system with cycles, all sets bounded by straight lines: each set is a union of convex
// cells; a choice of one cell for each set is a linear program in all positions together, and its projections are
// convex polygons, segments or points. A choice is extended set by set and given up where the program has no solution.
// P_i is the union over all choices. Guarantee: exact; closed sets by closed cells, others by relatively open ones.
// Where the limit comes first, the regions hold the choices found so far. Cost: at worst the product of the numbers of
// cells; each choice some milliseconds. Keywords: branch and bound, disjunctive programming, polyhedral projection.
#pragma once

#include "planning/planar/pair_system.h"

namespace findspace::planning {

/// Precondition: no set has arcs; every own set is bounded.
Projections search_cells(const PairSystem& system, const Limit& limit);

}  // namespace findspace::planning
