// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value over all positions of a convex distance whose values come with the points that take them: mu to a
// convex shape, the Hausdorff distance of two. Where the value is |b - a| the distance grows along b - a as fast as the
// position moves, and lies above that tangent everywhere; the next position is where the highest tangent is lowest.
// Guarantee: `value` is taken at `at`, and no position has less than `bound`: they agree to 2^-36 of the box, unless
// kMostTangents were not enough. Cost: a value and a small linear program for each tangent, mostly some dozens. Source:
// Kelley 1960 (cutting planes). Keywords: convex minimisation, subgradient.
#pragma once

#include <functional>
#include <optional>

#include "distance/search/least_in_box.h"
#include "distance/solid/solid_pair.h"

namespace findspace::distance {

inline constexpr int kMostTangents = 500;

/// The least is in the box. Nothing where a value has no points to tell the tangent; refused where one is.
TriedAnswer convex_least(const std::function<exact::Tried<Answer>(const space::RealVector&)>& value,
                         const space::Vector& low, const space::Vector& high);

}  // namespace findspace::distance
