// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Signs about points of a lattice as fine as one likes: coordinates are integers below 2^126. Guarantee: exact;
// products of 62-bit differences are made in 128 bits, others in 256. Cost: some nanoseconds. Keywords: orientation,
// orient2d.
#pragma once

#include "exact/number/wide_int.h"

namespace findspace::exact {

struct LatticePoint {
  int128 x = 0, y = 0;

  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
  friend LatticePoint operator+(const LatticePoint& p, const LatticePoint& q) { return {p.x + q.x, p.y + q.y}; }
  friend LatticePoint operator-(const LatticePoint& p, const LatticePoint& q) { return {p.x - q.x, p.y - q.y}; }
};

namespace detail {
inline bool is_short(int128 a) { return a == static_cast<std::int64_t>(a) && a >> 62 == a >> 63; }

/// The sign of a*b - c*d.
inline int sign_of_difference(int128 a, int128 b, int128 c, int128 d) {
  if (is_short(a) && is_short(b) && is_short(c) && is_short(d)) {
    const int128 left = a * b, right = c * d;
    return left < right ? -1 : left > right;
  }
  return compare(multiply(a, b), multiply(c, d));
}
}  // namespace detail

/// The sign of the cross product: +1 where d lies counter-clockwise of c, less than half a turn on.
inline int cross_sign(const LatticePoint& c, const LatticePoint& d) {
  return detail::sign_of_difference(c.x, d.y, c.y, d.x);
}

/// The sign of the dot product.
inline int dot_sign(const LatticePoint& c, const LatticePoint& d) {
  return detail::sign_of_difference(c.x, d.x, -c.y, d.y);
}

/// +1 where r lies on the left of the line from p to q, 0 on it, -1 on the right.
inline int turn_sign(const LatticePoint& p, const LatticePoint& q, const LatticePoint& r) {
  return cross_sign(q - p, r - p);
}

/// Whether r, which is on the line through p and q, lies between them or is one of them.
inline bool is_between(const LatticePoint& p, const LatticePoint& q, const LatticePoint& r) {
  const auto within = [](int128 a, int128 b, int128 c) { return a <= b ? a <= c && c <= b : b <= c && c <= a; };
  return within(p.x, q.x, r.x) && within(p.y, q.y, r.y);
}

/// Whether p is nearer than `distance` to the segment from a to b. Differences stay below 2^120.
inline bool is_nearer(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b, int128 distance) {
  const auto square = [](const LatticePoint& v) { return multiply(v.x, v.x) + multiply(v.y, v.y); };
  const LatticePoint way = b - a;
  const Int256 bound = multiply(distance, distance);
  if (dot_sign(p - a, way) <= 0) return square(p - a) < bound;
  if (dot_sign(p - b, way) >= 0) return square(p - b) < bound;
  const Int256 height = multiply(way.x, p.y - a.y) - multiply(way.y, p.x - a.x);
  return multiply(height, height) < multiply(bound, square(way));
}

}  // namespace findspace::exact
