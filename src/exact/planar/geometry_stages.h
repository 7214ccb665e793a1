// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What supporting_curve.cpp, geometry.cpp, geometry_signs.cpp and offset_points.h share: supporting curves and points
// as doubles with error bounds and as fixed-width integers, the first two stages of their predicates. Guarantee: bounds
// and integers are exact or certain.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/planar/geometry.h"

namespace findspace::exact {

inline Approx from_interval(Interval r) {
  if (r.lo == r.hi) return {r.lo, 0};
  double v = r.lo + (r.hi - r.lo) / 2;
  return {v, std::max(r.hi - v, v - r.lo) * Approx::kGrow};
}

/// The enclosure may be unbounded: that of a quotient whose divisor it does not tell from 0.
inline Approx from_real(const Real& r) {
  const Interval known = r.interval();
  if (known.hi - known.lo < kInfinity) return from_interval(known);
  const double v = r.to_double();
  return {v, std::abs(v) * (4 * Approx::kUnit) + Approx::kTiny};
}

inline Approx from_int(int128 k) {
  constexpr std::int64_t kExact = std::int64_t(1) << 53;
  const std::int64_t narrow = std::int64_t(k);
  const double v = narrow == k ? double(narrow) : double(k);
  return {v, narrow == k && narrow <= kExact && narrow >= -kExact ? 0.0 : std::abs(v) * Approx::kUnit * 2};
}

inline int sign_of(int128 k) { return (k > 0) - (k < 0); }

inline int128 cross(const SupportingCurve& p, const SupportingCurve& q) {
  return int128(p.a) * q.b - int128(p.b) * q.a;
}

/// A grid line whose crossings with others like it have numerators below 2^126.
inline bool is_narrow(const SupportingCurve& l) {
  constexpr std::int64_t kNormal = std::int64_t(1) << 42;
  constexpr int128 kOffset = int128(1) << 83;
  return l.grid && !l.circle && l.a < kNormal && l.b < kNormal && l.b > -kNormal && l.c < kOffset && l.c > -kOffset;
}

/// Homogeneous coordinates of the crossing of two narrow lines: |x|, |y| < 2^126, 0 < weight < 2^85.
struct NarrowPoint {
  int128 x, y, weight;
};

inline NarrowPoint narrow_crossing(const SupportingCurve& s, const SupportingCurve& t) {
  int128 w = cross(s, t), x = s.c * t.b - t.c * s.b, y = t.c * s.a - s.c * t.a;
  return w > 0 ? NarrowPoint{x, y, w} : NarrowPoint{-x, -y, -w};
}

/// Squared radius times squared normal length minus squared unscaled distance: > 0 when line and circle cross.
inline Real crossing_discriminant(const SupportingCurve& line, const SupportingCurve& circle) {
  Real n2 = Real(int128(line.a) * line.a + int128(line.b) * line.b);
  Real h = Real(line.a) * circle.center_x() + Real(line.b) * circle.center_y() - line.offset();
  return circle.w() * circle.w() * n2 - h * h;
}

/// The length of a line's normal: off by at most 3 * 2^-53 of it, as below.
inline Approx normal_length(const SupportingCurve& l) {
  double a = double(l.a), b = double(l.b), n = std::sqrt(a * a + b * b);
  return {n, n * (4 * Approx::kUnit)};
}

/// The length of the primitive vector (a, b) if it is an integer. Below 2^50 its root in doubles, off by at most 2
/// ulps, tells most others: nearly always, so that the branch is foreseen (last bits of a and b would tell only half).
inline std::optional<int128> integer_length(std::int64_t a, std::int64_t b) {
  constexpr double kRounding = 0x1.8p52;  // added and taken away again it rounds to an integer
  const double x = double(a), y = double(b), n = std::sqrt(x * x + y * y);
  if (n < 0x1p50 && std::abs(n - ((n + kRounding) - kRounding)) > n * (4 * Approx::kUnit)) return std::nullopt;
  int128 square = int128(a) * a + int128(b) * b, root = int128(std::llround(std::sqrt(double(square))));
  return root * root == square ? std::optional(root) : std::nullopt;
}

inline Approx line_offset(const SupportingCurve& l) {
  if (const RealPoint* at = l.real()) return from_real(at->x);
  return l.grid ? from_int(l.c) : from_int(l.c) + from_real(l.w()) * normal_length(l);
}

/// Whether a coordinate may be held as a grid coordinate.
inline bool fits(const std::optional<int128>& c) {
  constexpr int128 kMost = int128(1) << 62;
  return c && *c <= kMost && *c >= -kMost;
}

/// |a|, |b| <= 2^62. With u = 2^-53 each is rounded by at most u, so the squared length is off by at most 4u (twice
/// that, and two roundings on each path). Its root is off by 3u (half of that and its own rounding), the reciprocal by
/// 4u, and a product with it, of a rounded normal or offset, by 6u; 7u and 8u cover the terms of second order. An
/// integer over a length of 2^63 does not underflow.
inline SupportingCurve::LineFilter grid_line_filter(std::int64_t a, std::int64_t b, int128 c) {
  const double p = double(a), q = double(b), over = 1 / std::sqrt(p * p + q * q), x = p * over, y = q * over;
  const std::int64_t narrow = std::int64_t(c);
  const double z = (narrow == c ? double(narrow) : double(c)) * over;
  return {x, y, z, ErrorBound::units<7>(x), ErrorBound::units<7>(y), ErrorBound::units<8>(z)};
}

/// One coordinate of a point, for less than both.
Real exact_coordinate(const Geometry& g, const Point& p, bool x_axis);

/// Of any line.
void set_line_filter(SupportingCurve& l);

}  // namespace findspace::exact
