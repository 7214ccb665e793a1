// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least or greatest x or y coordinate over a set of positions, and the positions that have it: points and straight edges
// (distances.md 4.4, 6.2). Guarantee: exact; attained or not is told from the marks. Cost: linear in the cells, one overlay.
// Keywords: bottom-left, extreme point, lexicographic minimum.
#pragma once

#include "distance/extremum.h"

namespace findspace::distance {

enum class Axis { kX, kY };

Extremum coordinate_extremum(const plane::Region& s, Axis axis, Sense sense);

}  // namespace findspace::distance
