// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What no layout of all parts is below. Of a strip a length: the greater of all areas over the height, and the width of
// the widest part at its narrowest angle. On sheets a number of them, by areas (fewest_bins.h) and what is fixed. Of a
// box 0. Guarantee: certain; areas of parts are rounded down, those of sheets up. Cost: linear, and sorting.
#pragma once

#include "packing/problem/problem.h"

namespace findspace::packing {

Fraction lower_bound(const Problem& problem);

}  // namespace findspace::packing
