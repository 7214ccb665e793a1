// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value over a box of positions of a function that changes by at most the length of a step. Best first: the
// boxes of least bound (the value at the centre minus half the diagonal) are divided in eight, a fixed number at a time
// whatever the number of threads. Guarantee: `value` is taken at `at`; none in the box is less than `bound`. They agree
// to 2^-30 of the box and what the values may be off, unless so many values were not enough. Keywords: Lipschitz
// optimisation, branch and bound.
#pragma once

#include <functional>
#include <optional>

#include "distance/answer/answer.h"
#include "space/polytope/real_vector.h"

namespace findspace::distance {

inline constexpr int kMostValues = 20000;

/// That at a position, as the least value; no position has less than `bound`.
Answer least_taken(const space::RealVector& at, const Answer& value, const exact::Real& bound);

/// The least of a function that changes by at most the length of a step, over a box; `floor`: a bound that is known.
/// `value` is called from many threads; refused where it is.
exact::Tried<Answer> least_in_box(const std::function<exact::Tried<Answer>(const space::RealVector&)>& value,
                                  const space::Vector& low, const space::Vector& high, double floor,
                                  int most = kMostValues);

inline constexpr int kMostTangents = 500;

/// The least over all positions of a convex distance whose values come with the points that take them: mu to a convex
/// shape, the Hausdorff distance of two, the reach, the farthest fit. Where the value is |b - a| the distance grows
/// along b - a as fast as the position moves, and lies above that tangent everywhere; the next position is where the
/// highest tangent is lowest (Kelley 1960, cutting planes). `value` and `bound` agree to 2^-36 of the box, unless
/// kMostTangents were not enough. The least is in the box. Nothing where a value has no points to tell the tangent;
/// refused where one is.
TriedAnswer convex_least(const std::function<exact::Tried<Answer>(const space::RealVector&)>& value,
                         const space::Vector& low, const space::Vector& high);

}  // namespace findspace::distance
