// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact signs of ray maps (space/ray_*): places of events along a line as fractions, which of two comes first, on which
// side of a projected edge a line passes, and orientations of points of two bodies, one of which is moved.
//
// Coordinates are integers, |coordinate| <= 2^38 for bodies and lines (kRayLimit), so corners of a convolution, sums of
// two, are at most 2^39, differences 2^40, normals 2^81 and numerators of events 2^124: a fraction fits in two int128
// and comparing two of them in 256 bits. The overlap test works on coordinates multiplied by the denominator of a
// position, up to 2^60: differences 2^61, a volume below 2^190, again 256 bits. Guarantee: every sign is exact. Cost: a
// filter in doubles, some ten nanoseconds where it fails.
#pragma once

#include <cmath>
#include <optional>

#include "exact/number/real.h"
#include "exact/number/wide_int.h"
#include "exact/solid/space_sign.h"

namespace findspace::exact {

inline constexpr std::int64_t kRayLimit = std::int64_t{1} << 38;

/// numerator / denominator, not reduced; the denominator is positive.
struct Fraction {
  int128 numerator = 0, denominator = 1;
};

/// The fraction in lowest terms.
Fraction reduced(const Fraction& f);
double to_double(const Fraction& f);
inline Real to_real(const Fraction& f) { return Real(f.numerator) / Real(f.denominator); }

/// The sign of a - b.
int compare_fractions(const Fraction& a, const Fraction& b);
/// A fraction strictly between a < b, of small denominator where the gap allows one.
Fraction between(const Fraction& a, const Fraction& b);

/// The sign of (b - a) x (p - a) in the plane: + if p is left of the line from a to b. Differences below 2^62.
inline int sign_turn(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, std::int64_t px,
                     std::int64_t py) {
  const double u = static_cast<double>(bx - ax) * static_cast<double>(py - ay);
  const double v = static_cast<double>(by - ay) * static_cast<double>(px - ax);
  // Two roundings of the factors, one of each product, one of the difference: below 2^-50 of the magnitudes.
  const double bound = 0x1p-50 * (std::fabs(u) + std::fabs(v));
  if (u - v > bound) return 1;
  if (u - v < -bound) return -1;
  return sign(int128(bx - ax) * (py - ay) - int128(by - ay) * (px - ax));
}

/// The sign of (b - a) x (c - a) . (d - a): + if a, b, c run counter-clockwise seen from d's opposite side, that is, d
/// lies on the side of the normal. Coordinates up to 2^60.
int sign_volume(const Grid3& a, const Grid3& b, const Grid3& c, const Grid3& d);

/// A point of one of two bodies; those of the moved body are raised along z by a fraction of a step.
struct RaisedPoint {
  Grid3 at;
  bool raised = false;
};

/// The same for p displaced by infinitesimals, to the right and, less, upward: 0 only if a = b.
inline int sign_turn_displaced(const Grid3& a, const Grid3& b, std::int64_t px, std::int64_t py) {
  const int s = sign_turn(a.x, a.y, b.x, b.y, px, py);
  if (s != 0) return s;
  return a.y != b.y ? (a.y > b.y ? 1 : -1) : (b.x > a.x) - (b.x < a.x);
}

/// The sign of the volume when the raised points stand `by` higher, 0 <= by < 1.
int sign_volume(const RaisedPoint& a, const RaisedPoint& b, const RaisedPoint& c, const RaisedPoint& d,
                const Fraction& by);

/// The sign of component `axis` of (b - a) x (c - a).
int sign_turn(const RaisedPoint& a, const RaisedPoint& b, const RaisedPoint& c, int axis, const Fraction& by);

/// The sign of a - b in coordinate `axis`.
int compare_coordinate(const RaisedPoint& a, const RaisedPoint& b, int axis, const Fraction& by);

/// The sign of l x m . n for normals of components up to 2^79.
int sign_triple(const Wide3& l, const Wide3& m, const Wide3& n);

/// The sign of the first component of l x m that is not zero; 0 for parallel normals.
int lexicographic_sign_cross(const Wide3& l, const Wide3& m);

/// The sign of the first component of a vector that is not zero.
template <class V>
int lexicographic_sign(const V& v) {
  if (v.x != 0) return v.x > 0 ? 1 : -1;
  if (v.y != 0) return v.y > 0 ? 1 : -1;
  return v.z > 0 ? 1 : v.z < 0 ? -1 : 0;
}

/// The sign of normal . edge.
inline int sign_dot(const Wide3& normal, const Approx3& normal_approx, const Grid3& edge) {
  const int fast = filtered_sign_dot(normal_approx, approx(edge));
  return fast != 2 ? fast : sign(dot(normal, edge));
}

}  // namespace findspace::exact
