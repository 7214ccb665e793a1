// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Every sign that the planar kernel needs about the curves and points of a Geometry. Points and curves are given by
// their numbers.
//
// Guarantee: every function that returns a sign or a truth value is exact. Stages: double with a running error bound;
// fixed-width integers where all data are grid lines and grid points; exact reals (closed forms, then a separation
// bound). Cost: a few nanoseconds in the first two stages, microseconds in the last.
// Source: the staging follows S2's predicates and the exact geometric computation paradigm (Yap 1997).
// Keywords: predicate, orientation, filter.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "exact/planar/geometry.h"

namespace findspace::exact {

namespace detail {

/// Sign of x - y where it exceeds `error` (inflated for its rounding) and the rounding of the difference, 2^-52 of it.
inline int filtered(double x, double y, double error) {
  double gap = x - y, tolerance = error * Approx::kGrow + std::abs(gap) * Approx::kUnit * 2;
  return (gap > tolerance) - (gap < -tolerance);
}

/// The later stages.
int staged_compare(const Geometry& g, std::uint32_t p, std::uint32_t q, bool x_axis);
int staged_side(const Geometry& g, std::uint32_t p, std::uint32_t supporting_curve);

}  // namespace detail

inline int compare_x(const Geometry& g, std::uint32_t p, std::uint32_t q) {
  const Point &a = g.points[p], &b = g.points[q];
  int s = detail::filtered(a.x, b.x, a.error + b.error);
  return s != 0 ? s : detail::staged_compare(g, p, q, true);
}

inline int compare_y(const Geometry& g, std::uint32_t p, std::uint32_t q) {
  const Point &a = g.points[p], &b = g.points[q];
  int s = detail::filtered(a.y, b.y, a.error + b.error);
  return s != 0 ? s : detail::staged_compare(g, p, q, false);
}

/// Lexicographic: x first, then y. 0 exactly when the points are equal.
int compare_xy(const Geometry& g, std::uint32_t p, std::uint32_t q);

/// Line: sign of a*x + b*y - c. Circle: sign of the squared distance to the centre minus the squared radius.
inline int side(const Geometry& g, std::uint32_t p, std::uint32_t supporting_curve) {
  const Point& q = g.points[p];
  const SupportingCurve& k = g.supporting_curves[supporting_curve];
  if (q.kind != Point::Kind::kGrid || !k.grid || k.circle) return detail::staged_side(g, p, supporting_curve);
  int128 s = int128(k.a) * q.gx + int128(k.b) * q.gy - k.c;
  return (s > 0) - (s < 0);
}

inline bool lies_on(const Geometry& g, std::uint32_t p, std::uint32_t supporting_curve) {
  return side(g, p, supporting_curve) == 0;
}

/// Circle: sign of (y of p) - (y of the centre).
int above_center(const Geometry& g, std::uint32_t p, std::uint32_t circle);
/// Circle: sign of (x of p) - (x of the centre).
int right_of_center(const Geometry& g, std::uint32_t p, std::uint32_t circle);

/// How two different supporting curves meet: 0, 1 or 2 points. Root values to give to add_crossing; a tangency has
/// one point.
struct Meeting {
  int count = 0;
  std::array<int, 2> root{0, 0};
};
Meeting meet(const Geometry& g, std::uint32_t i, std::uint32_t j);

/// Is p by its definition the only common point of supporting curves i and j, not both lines? (False may be for want
/// of knowledge.)
bool touch_at(const Geometry& g, std::uint32_t p, std::uint32_t i, std::uint32_t j);

/// A direction of travel at a point: along a line, or along a circle's tangent there. `forward` on a line is
/// (b, -a), on a circle counter-clockwise.
struct Heading {
  std::uint32_t supporting_curve = 0;
  bool forward = true;
};
/// Sign of the cross product of the two tangent directions at p: +1 when `k` is to the left of `h`.
int turn(const Geometry& g, std::uint32_t p, Heading h, Heading k);
/// Sign of the dot product of the two tangent directions at p.
int along(const Geometry& g, std::uint32_t p, Heading h, Heading k);
/// Sign of curvature(h) - curvature(k), curvature positive when turning left.
int compare_curvature(const Geometry& g, Heading h, Heading k);

}  // namespace findspace::exact
