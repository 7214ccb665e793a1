// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What no layout of all solids is below. Upon a floor a height: the greater of all volumes over the floor, and the
// highest part in its lowest form. In containers a number of them, by volumes (fewest_bins.h) and what is fixed. Where
// there is a gap, a part takes besides no less than what lies within half the gap of a ball of its volume.
// Guarantee: certain: volumes are exact, with a gap rounded down, and of convex parts that may overlap only the largest
// counts; the quotient is rounded down to nine decimals. Cost: linear, and sorting. Source: the inequality of Brunn and
// Minkowski.
#pragma once

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

Fraction lower_bound(const SolidProblem& problem);

}  // namespace findspace::packing
