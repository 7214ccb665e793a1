// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// E, the positions at which a body B lies in A, a union of convex parts with radii, which no few convex functions
// describe, as B may lie partly in one part and partly in others: a provider of position_set.h. How far B protrudes at
// the corners of a cell says that nothing of it is in E, as no step changes it by more than its length; points of B
// that protrude say so to the square of a cell's size. Each has to be in one of few parts of A:
// the least of linear functions is to be at most 0, so minus that is convex and at least 0. Guarantee: doubles; as
// boundary_search.h. Cost: some hundred cells of 0.2 ms for polyhedra, of some milliseconds for a round B. Keywords:
// erosion, containment, disjunctive constraint, reverse convex programming.
#pragma once

#include "distance/search/position_set.h"

namespace findspace::distance {

/// Of B in A; E lies in the box.
PositionSet fits_in_union(const space::Body& b, const space::Body& a, const PositionSet::Box& box);

}  // namespace findspace::distance
