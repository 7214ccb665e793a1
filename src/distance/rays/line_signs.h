// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signs along a line that a search in numbers found, stretch by stretch, as a line of a ray map. Guarantee: where
// the sign changes, it is 0 at the place of the change; what is below 2^-62 of a step is lost. Keywords: ray map.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "space/polytope/real_vector.h"
#include "space/rays/ray_map.h"

namespace findspace::distance {

/// The line start + t * unit of positions; the unit has length 1.
struct PositionLine {
  space::RealVector start, unit;
};
/// Line (i, j) of the grid. `part`: a part of its steps, in steps of the positions.
PositionLine position_line(const space::RayGrid& grid, double part, int i, int j);
/// Of all lines, of length 1.
space::Vector line_direction(const space::RayGrid& grid);

struct SignStretch {
  double from, to;
  int sign;
};
/// Adds the line, whose stretches come by growing place without gaps; before and behind them the sign is `outer`, not
/// 0. Where signs change there is a stretch of 0.
void put_line(std::span<const SignStretch> known, double part, space::RayRow& row, int outer = 1);

/// A place along a ray that a search found: the double itself, as a fraction; what is below 2^-62 is lost.
inline space::RayPosition ray_place(double z) {
  int exponent = 0;
  const double mantissa = std::frexp(z, &exponent);
  const int down = std::clamp(53 - exponent, 0, 62);
  const auto numerator = static_cast<exact::int128>(std::ldexp(mantissa, exponent + down));
  space::RayPosition at;
  at.exact = exact::reduced({numerator, exact::int128(1) << down});
  at.value = exact::to_double(at.exact);
  return at;
}

}  // namespace findspace::distance
