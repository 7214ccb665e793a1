// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A length below which no layout of the strip can be. It is the greater of two: all areas over the height, and the
// width of the widest part at its narrowest angle. Guarantee: certain; the area is rounded down. Cost: linear.
#pragma once

#include "packing/problem/problem.h"

namespace findspace::packing {

Fraction lower_bound(const Problem& problem);

}  // namespace findspace::packing
