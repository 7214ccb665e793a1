// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A height below which no layout in space can be. It is the greater of two: all volumes over the floor, and the highest
// part. Guarantee: certain; the volume is rounded down, and of parts that may overlap only the largest counts.
// Cost: linear.
#pragma once

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

Fraction lower_bound(const SolidProblem& problem);

}  // namespace findspace::packing
