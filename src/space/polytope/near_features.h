// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The place of a triangle that is nearest to the origin, and the shortest way between two segments inside both, for
// doubles and for exact numbers. Guarantee: exact for Real; in doubles never nearer than true but for roundings, and
// farther by no more than 2^-18 of the longest edge where a projection is hard to tell. Source: Ericson, Real-Time
// Collision Detection, 2004, 5.1. Keywords: point to triangle, segment to segment.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "exact/margins/space.h"
#include "exact/number/real.h"
#include "space/polytope/vector.h"

namespace findspace::space::near {

template <class T>
using Triple = std::array<T, 3>;

inline Triple<double> triple(const Vector& v) { return {v.x, v.y, v.z}; }

template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Triple<T> minus(const Triple<T>& a, const Triple<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// a + s * u.
template <class T>
Triple<T> along(const Triple<T>& a, const T& s, const Triple<T>& u) {
  return {a[0] + s * u[0], a[1] + s * u[1], a[2] + s * u[2]};
}

/// Of the triangle a, b, c to the origin.
template <class T>
Triple<T> nearest_of_triangle(const Triple<T>& a, const Triple<T>& b, const Triple<T>& c) {
  const T zero(0);
  const Triple<T> ab = minus(b, a), ac = minus(c, a);
  const T a1 = zero - dot(ab, a), a2 = zero - dot(ac, a);
  if (!(zero < a1) && !(zero < a2)) return a;
  const T b1 = zero - dot(ab, b), b2 = zero - dot(ac, b);
  if (!(b1 < zero) && !(b1 < b2)) return b;
  const T by_c = a1 * b2 - b1 * a2;
  if (!(zero < by_c) && !(a1 < zero) && !(zero < b1)) return along<T>(a, a1 / (a1 - b1), ab);
  const T c1 = zero - dot(ab, c), c2 = zero - dot(ac, c);
  if (!(c2 < zero) && !(c2 < c1)) return c;
  const T by_b = c1 * a2 - a1 * c2;
  if (!(zero < by_b) && !(a2 < zero) && !(zero < c2)) return along<T>(a, a2 / (a2 - c2), ac);
  const T by_a = b1 * c2 - c1 * b2, to_c = b2 - b1, to_b = c1 - c2;
  if (!(zero < by_a) && !(to_c < zero) && !(to_b < zero)) return along<T>(b, to_c / (to_c + to_b), minus(c, b));
  const T all = by_a + by_b + by_c;
  return along<T>(along<T>(a, by_b / all, ab), by_c / all, ac);
}

/// Its squared distance from the origin, in doubles.
inline double squared_of_segment(const Triple<double>& a, const Triple<double>& b) {
  const Triple<double> e = minus(b, a);
  const Triple<double> projection = along(a, std::clamp(-dot(a, e) / dot(e, e), 0.0, 1.0), e);
  return dot(projection, projection);
}
inline double squared_of_triangle(const Triple<double>& a, const Triple<double>& b, const Triple<double>& c) {
  const Triple<double> projection = nearest_of_triangle(a, b, c);
  double least = dot(projection, projection);
  // An edge of no length has no number.
  for (const double d : {squared_of_segment(a, b), squared_of_segment(b, c), squared_of_segment(c, a)})
    least = d < least ? d : least;
  return least;
}

/// From the nearest place of the segment b, b + v to that of a, a + u, where these are not ends of lines that are
/// parallel.
inline std::optional<Triple<exact::Real>> way_between(const Triple<exact::Real>& a, const Triple<exact::Real>& u,
                                                      const Triple<exact::Real>& b, const Triple<exact::Real>& v) {
  using exact::Real;
  const Triple<Real> w = minus(a, b);
  const Real uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const Real all = uu * vv - uv * uv, on_u = uv * vw - vv * uw, on_v = uu * vw - uv * uw;
  const auto within = [&](const Real& t) { return t.sign() >= 0 && t <= all; };
  if (all.sign() == 0 || !within(on_u) || !within(on_v)) return std::nullopt;
  return along<Real>(along<Real>(w, on_u / all, u), -(on_v / all), v);
}

/// The squared length of it in doubles; infinite where it is clearly none.
inline double squared_between(const Triple<double>& a, const Triple<double>& u, const Triple<double>& b,
                              const Triple<double>& v) {
  const Triple<double> w = minus(a, b);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double all = uu * vv - uv * uv, tolerance = margin::kBeyondEnd * all;
  const double on_u = uv * vw - vv * uw, on_v = uu * vw - uv * uw;
  const auto within = [&](double t) { return t >= -tolerance && t <= all + tolerance; };
  // Of nearly parallel ones the ends are as near.
  if (all <= margin::kParallelEdges * uu * vv || !within(on_u) || !within(on_v)) return exact::kInfinity;
  const double t = std::clamp((uv * std::clamp(on_u / all, 0.0, 1.0) + vw) / vv, 0.0, 1.0);
  const double s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
  const Triple<double> way = along(along(w, s, u), -t, v);
  return dot(way, way);
}

}  // namespace findspace::space::near
