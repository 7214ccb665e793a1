// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Moving contact curves as equations nx * x + ny * y = h whose coefficients depend on the angle, and what is 0 where
// two of them meet at a given distance from the origin, or three in one point. For polynomials in doubles (HalfAngle,
// where 1 + u^2 below is left out) and exact ones (RotationPolynomial). Guarantee: formulas without division, so exact
// where the arithmetic is. Keywords: concurrency, circumcircle, radical line.
#pragma once

#include <algorithm>
#include <array>

#include "exact/planar/rotation_polynomial.h"
#include "plane/base/half_angle.h"

namespace findspace::plane {

/// A line; or a circle, (nx, ny) being its centre and h = |centre|^2 - radius^2.
template <class P, class Number>
struct CurveForm {
  bool line = false;
  P nx, ny, h;
  Number radius{};
};
using SectorCurve = CurveForm<HalfAngle, double>;
using ExactSectorCurve = CurveForm<exact::RotationPolynomial, exact::Real>;

inline HalfAngle constant_of(double value, const HalfAngle&) { return HalfAngle::linear(value, 0, 0); }
inline exact::RotationPolynomial constant_of(const exact::Real& value, const exact::RotationPolynomial&) {
  return exact::RotationPolynomial::constant(value);
}
inline exact::RotationPolynomial raised(const exact::RotationPolynomial& p) { return p; }

/// nx * x + ny * y = h.
template <class P>
struct LineForm {
  P nx, ny, h;
};

template <class P, class N>
LineForm<P> line_of(const CurveForm<P, N>& c) {
  return {c.nx, c.ny, c.h};
}

/// The line through the points that the circle shares with the one of radius `level` around the origin.
template <class P, class N>
LineForm<P> radical_line(const CurveForm<P, N>& c, const N& level) {
  return {c.nx + c.nx, c.ny + c.ny, c.h + constant_of(level * level, c.h)};
}

/// The line through the points that two circles share.
template <class P, class N>
LineForm<P> radical_line(const CurveForm<P, N>& c, const CurveForm<P, N>& d) {
  const P x = d.nx - c.nx, y = d.ny - c.ny;
  return {x + x, y + y, d.h - c.h};
}

/// The meeting point of two lines is (x, y) / w.
template <class P>
struct Meeting {
  P x, y, w;
};

template <class P>
Meeting<P> meeting(const LineForm<P>& f, const LineForm<P>& g) {
  return {f.h * g.ny - g.h * f.ny, f.nx * g.h - g.nx * f.h, f.nx * g.ny - f.ny * g.nx};
}

/// Of two lines that are parallel at every angle (w = 0): 0 wherever they are one, and perhaps elsewhere.
inline exact::RotationPolynomial where_one(const Meeting<exact::RotationPolynomial>& m) {
  return m.x.is_zero() ? m.y : m.x;
}

/// The lines in whose meeting point two curves can meet at a distance `level` from the origin.
template <class P, class N>
std::array<LineForm<P>, 2> corner_lines(const CurveForm<P, N>& c, const CurveForm<P, N>& d, const N& level) {
  return {c.line ? line_of(c) : radical_line(c, level), d.line ? line_of(d) : radical_line(d, level)};
}

template <class P, class N>
P corner_polynomial(const Meeting<P>& m, const N& level) {
  return m.x * m.x + m.y * m.y - (level * level) * (m.w * m.w);
}

/// Three curves in an order with circles first.
template <class P, class N>
std::array<const CurveForm<P, N>*, 3> ordered(const CurveForm<P, N>& c, const CurveForm<P, N>& d,
                                              const CurveForm<P, N>& e) {
  std::array<const CurveForm<P, N>*, 3> all{&c, &d, &e};
  std::stable_sort(all.begin(), all.end(), [](const auto* p, const auto* q) { return p->line < q->line; });
  return all;
}

/// The lines in whose meeting point three curves can meet, the first of them given.
template <class P, class N>
std::array<LineForm<P>, 2> meeting_lines(const std::array<const CurveForm<P, N>*, 3>& c) {
  const auto form = [&](const CurveForm<P, N>& s) { return s.line ? line_of(s) : radical_line(*c[0], s); };
  return {form(*c[1]), form(*c[2])};
}

/// Whether the first curve passes that meeting point.
template <class P, class N>
P meeting_polynomial(const CurveForm<P, N>& first, const Meeting<P>& m) {
  if (first.line) return first.nx * m.x + first.ny * m.y - first.h * m.w;
  const P x = raised(m.x) - first.nx * m.w, y = raised(m.y) - first.ny * m.w, w = first.radius * raised(m.w);
  return x * x + y * y - w * w;
}

}  // namespace findspace::plane
