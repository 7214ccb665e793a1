// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A finite set of points with exact real coordinates as a region: isolated vertices in the plane. Guarantee: exact.
#pragma once

#include <span>

#include "plane/complex/cell_complex.h"

namespace findspace::distance {

/// The points with mark `in`, all else with mark `out`. The points must differ.
plane::CellComplex point_set(std::span<const exact::RealPoint> points, plane::Mark in = 1, plane::Mark out = 0);

}  // namespace findspace::distance
