// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Crossings near a grid point, where both curves are known to be equally far from it: the corners of offsets. They are
// points like any other crossing; only their approximate coordinates, the first stage of every predicate, are found
// from that point, with one division and off by about the rounding of the coordinates however flat the corner is.
// Guarantee: the error bound of the coordinates holds. Cost: O(1). Keywords: parallel curve, miter join.
#pragma once

#include "exact/planar/geometry.h"

namespace findspace::exact {

/// A line at the signed distance `shift` along its unit normal from the grid point (x, y).
struct ShiftedLine {
  std::uint32_t supporting_curve;
  Approx shift;
};

/// As the shift of a line.
Approx approx(const Real& shift);

/// Where two lines cross that are not parallel; their shifts from (x, y) are equal or opposite, and not 0.
std::uint32_t add_shifted_crossing(Geometry& g, const ShiftedLine& p, const ShiftedLine& q, std::int64_t x,
                                   std::int64_t y);

/// Where a line touches the circle about (x, y) whose radius is its distance.
std::uint32_t add_shifted_touch(Geometry& g, const ShiftedLine& line, std::uint32_t circle, std::int64_t x,
                                std::int64_t y);

}  // namespace findspace::exact
