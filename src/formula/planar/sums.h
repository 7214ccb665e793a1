// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of distances of a formula or an objective, "gap(B, A) + 2 * gap(B, C)", as functions of the position
// (distance_sum.h), in grid steps; and the region of a formula in which they are compared, "gap(B, A) <= gap(B, C)".
// There the conditions without sums are solved exactly first; where these are all `and`ed they bound the positions, and
// the sums' signs are found in that window (sum_map.h). Guarantee: inner and outer sets; the same where bisectors are
// lines with a direction in integers or circles. Cost: that of the plain conditions, and of the sum maps. Keywords:
// weighted sum, wire length, bisector, Voronoi region, enclosure.
#pragma once

#include <span>

#include "distance/planar_least/distance_sum.h"
#include "formula/language/formula.h"
#include "formula/language/position_answers.h"
#include "formula/planar/solve.h"

namespace findspace::formula {

/// Throws Error(kUnsupported) for distances that are no T-distances, and with a motion.
distance::DistanceSum distance_sum(const PreparedWorld& world, std::span<const SumTerm> terms);
/// The distance and what more an atom has.
std::vector<SumTerm> terms_of(const SignMap& wanted);
/// The value of the sum at p.
DistanceAt sum_at(const PreparedWorld& world, const SignMap& wanted, std::string text, const exact::RealPoint& p);
/// No shape of the sum reaches farther than this from its place, all together.
double reach_of(const PreparedWorld& world, std::span<const SumTerm> terms);

/// Precondition: no shape rotates. Over unbounded positions nothing is certain beyond a window about all shapes.
RegionBounds sum_region_bounds(const Solver& solver, const Formula& formula);

}  // namespace findspace::formula
