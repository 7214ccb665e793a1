// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A height below which no layout in space can be. It is the greater of two: all volumes over the floor, and the highest
// part in its lowest form. Guarantee: certain: volumes are exact, and of convex parts that may overlap only the largest
// counts; the quotient is rounded down to nine decimals. Cost: linear.
#pragma once

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

Fraction lower_bound(const SolidProblem& problem);

}  // namespace findspace::packing
