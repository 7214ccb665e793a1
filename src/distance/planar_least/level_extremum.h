// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least or greatest value over a set S of positions of any function that has exact sign maps: distances over time,
// which are T-distances no more, and distances along a direction, which jump (extremum.h serves the others, and proves
// more). Method: bisection on the level, each step one exact answer to "does S meet {f <= level}?". Guarantee: where
// the value is a whole number of grid steps, that is proven, and the positions are exact; else it is given from the
// side of S, right to 2^-20 of a grid step or 2^-48 of itself, whichever is more. A function that jumps may have an
// infimum that nothing takes; its value is then approached. Cost: 50 to 80 sign maps and overlays. Keywords: argmin,
// bisection, constrained minimum.
#pragma once

#include "distance/planar_least/extremum.h"

namespace findspace::distance {

/// `continuous`: an extremum that no position of S takes is taken on the closure.
Extremum level_extremum(const PositionFunction& f, const plane::Region& s, Sense sense, bool continuous);

}  // namespace findspace::distance
