// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The square cells around the lines of a grid. Guarantee: rounded up.
#pragma once

#include <cmath>

#include "exact/margins/rounding.h"
#include "space/rays/ray_map.h"

namespace findspace::space {

/// How far a place of a line's cell may be from the line, in grid steps.
inline exact::Real cell_radius(const RayGrid& grid) {
  const double half = std::hypot(static_cast<double>(grid.du), static_cast<double>(grid.dv)) / 2;
  return exact::Real::from_double(half * margin::kUpward) / exact::Real(grid.parts);
}

}  // namespace findspace::space
