// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The curves of offsets and their corners. All curves of one offset are displaced by the same number, so its exact
// reals and its double are made once. Corners are crossings near a grid point, where both curves are known to be
// equally far from it. They are points like any other crossing; only their approximate coordinates, the first stage of
// every predicate, are found from that point, with one division and off by about the rounding of the coordinates
// however flat the corner is.
// Guarantee: the error bound of the coordinates holds. Cost: O(1). Keywords: parallel curve, miter join.
#pragma once

#include "exact/planar/geometry.h"

namespace findspace::exact {

/// How far curves are displaced: a signed distance of lines along their unit normals, not 0, or a radius.
struct Displacement {
  explicit Displacement(const Real& w);

  CurveReals reals;
  Approx near;
};

/// A grid line moved along its unit normal, with the filter of its direction.
std::uint32_t add_displaced(Geometry& g, const SupportingCurve& line, const Displacement& shift);
/// A circle about a grid point.
std::uint32_t add_circle(Geometry& g, std::int64_t x, std::int64_t y, const Displacement& radius);

/// A line at the signed distance `shift` along its unit normal from the grid point (x, y).
struct ShiftedLine {
  std::uint32_t supporting_curve;
  const Displacement& shift;
};

/// Where two lines cross that are not parallel; their shifts from (x, y) are equal or opposite.
std::uint32_t add_shifted_crossing(Geometry& g, const ShiftedLine& p, const ShiftedLine& q, std::int64_t x,
                                   std::int64_t y);

/// Where a line touches the circle about (x, y) whose radius is its distance.
std::uint32_t add_shifted_touch(Geometry& g, const ShiftedLine& line, std::uint32_t circle, std::int64_t x,
                                std::int64_t y);

}  // namespace findspace::exact
