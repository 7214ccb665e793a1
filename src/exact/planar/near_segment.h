// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a point is less than a given distance away from a segment: in one of the open discs about its ends, or in the
// open strip beside it. Guarantee: exact, in the stages of geometry.h. Cost: about 10 ns where doubles decide.
// Keywords: stadium, point-segment distance.
#pragma once

#include "exact/planar/geometry.h"

namespace findspace::exact {

/// Between two different grid points.
struct GridSegment {
  std::int64_t ax, ay, bx, by;
};

bool is_nearer(const Geometry& g, std::uint32_t point, const GridSegment& segment, const Real& distance);

}  // namespace findspace::exact
