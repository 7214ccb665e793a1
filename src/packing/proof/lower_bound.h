// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What no layout of all parts is below. Of a strip a length: the greater of all areas over the height, and the width of
// the widest part at its narrowest angle. On sheets a number of them, by areas (fewest_bins.h) and what is fixed. Of a
// box an area, by areas and by the side that some part needs both ways. Where there is a gap, a part takes besides what
// lies within half the gap of it. Guarantee: certain; what parts take is rounded down, at angles that are not of 90
// degrees by what their rounding may take away; what holds them is rounded up. Cost: an offset for each part where
// there is a gap; else linear, and sorting.
#pragma once

#include "packing/problem/problem.h"

namespace findspace::packing {

Fraction lower_bound(const Problem& problem);

}  // namespace findspace::packing
