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

#include <algorithm>
#include <cmath>

#include "exact/planar/geometry_stages.h"

namespace findspace::exact {

/// How far curves are displaced: a signed distance of lines along their unit normals, not 0, or a radius.
struct Displacement {
  explicit Displacement(const Real& w) : reals(w), near(from_real(w)) {}

  CurveReals reals;
  Approx near;
};

/// A line at the signed distance `shift` along its unit normal from a grid point.
struct ShiftedLine {
  std::uint32_t supporting_curve;
  const Displacement& shift;
};

namespace detail {

/// The crossing of two curves at (x, y), which is off by `moved` and the rounding of the coordinates: that of the grid
/// point, which is no farther from the origin than (x, y) and the way to it, and that of the sum.
inline std::uint32_t add_near(Geometry& g, std::uint32_t i, std::uint32_t j, double x, double y, double moved) {
  Point& p = g.points.emplace_back();
  p.kind = Point::Kind::kCross;
  p.i = std::min(i, j);
  p.j = std::max(i, j);
  p.x = x;
  p.y = y;
  p.error = (moved + std::max(std::abs(x), std::abs(y)) * (2 * Approx::kUnit)) * Approx::kGrow + Approx::kTiny;
  return std::uint32_t(g.points.size() - 1);
}

}  // namespace detail

/// A grid line moved along its unit normal, with the filter of its direction.
inline std::uint32_t add_displaced(Geometry& g, const SupportingCurve& line, const Displacement& shift) {
  if (integer_length(line.a, line.b))
    return g.add(SupportingCurve::displaced_line(line.a, line.b, line.c, shift.reals));
  SupportingCurve& l = g.supporting_curves.emplace_back(line);
  l.grid = false;
  l.reals = shift.reals;
  l.set_filter(l.x(), l.y(), l.z() + shift.near);
  return std::uint32_t(g.supporting_curves.size() - 1);
}

/// A circle about a grid point.
inline std::uint32_t add_circle(Geometry& g, std::int64_t x, std::int64_t y, const Displacement& radius) {
  SupportingCurve& k = g.supporting_curves.emplace_back();
  k.circle = true;
  k.a = x;
  k.b = y;
  k.reals = radius.reals;
  k.set_filter(from_int(x), from_int(y), radius.near);
  return std::uint32_t(g.supporting_curves.size() - 1);
}

/// Where two lines cross that are not parallel; their shifts from (x, y) are equal or opposite.
inline std::uint32_t add_shifted_crossing(Geometry& g, const ShiftedLine& p, const ShiftedLine& q, std::int64_t x,
                                          std::int64_t y) {
  // With unit normals m and n, rotated so that both lines are at the distance s from the point: the crossing is away
  // from it by s * (m + n) / (1 + m * n). With u = 2^-53 a normal is off by 7u (geometry_stages.h). So m * n is off by
  // 17u: twice 7u of terms whose sizes add up to 1 at most, and the roundings. The divisor is off by 19u with its own;
  // 20u and the rest below cover the terms of second order. Each coordinate of m + n is off by 16u, and 2 at most.
  constexpr double u = Approx::kUnit;
  const SupportingCurve &k = g.supporting_curves[p.supporting_curve], &l = g.supporting_curves[q.supporting_curve];
  const Approx& shift = q.shift.near;
  const bool opposite = (p.shift.near.value > 0) != (shift.value > 0);
  const double m = opposite ? -k.x().value : k.x().value, n = opposite ? -k.y().value : k.y().value;
  const double divisor = 1 + (m * l.x().value + n * l.y().value), least = divisor - 20 * u;
  if (!(least > 0)) return g.add_crossing(p.supporting_curve, q.supporting_curve, 0);
  const double by = shift.value / divisor, size = std::abs(by);
  const double by_error = (shift.error + size * (20 * u)) / least + size * u;
  return detail::add_near(g, p.supporting_curve, q.supporting_curve, double(x) + by * (m + l.x().value),
                          double(y) + by * (n + l.y().value), by_error * (2 + 64 * u) + size * (22 * u));
}

/// Where a line touches the circle about (x, y) whose radius is its distance.
inline std::uint32_t add_shifted_touch(Geometry& g, const ShiftedLine& line, std::uint32_t circle, std::int64_t x,
                                       std::int64_t y) {
  // Off by the error of the shift, and of its size by 7u of the normal, by one rounding, and by one of the grid point
  // that is farther from the origin than the touching point by so much.
  constexpr double u = Approx::kUnit;
  const SupportingCurve& k = g.supporting_curves[line.supporting_curve];
  const Approx& shift = line.shift.near;
  return detail::add_near(g, line.supporting_curve, circle, double(x) + shift.value * k.x().value,
                          double(y) + shift.value * k.y().value, 2 * shift.error + std::abs(shift.value) * (10 * u));
}

}  // namespace findspace::exact
