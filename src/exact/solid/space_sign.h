// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact signs of the 3D layer. Points are integers of the scene's grid, |coordinate| <= 2^40, so a difference of two
// points of one body is at most 2^41 and a difference of two vertices of A - B at most 2^42 (contact surfaces).
//
//   cross(e, f)            at most 2 * 2^41 * 2^41 = 2^83 in each component: int128 holds it
//   dot(cross(e, f), g)    at most 3 * 2^83 * 2^41 < 2^125: int128 holds it
//   offset of a facet of A - B: at most 3 * 2^83 * 2^41 < 2^125: int128 holds it
//
// Hence every combinatorial decision of hulls and contact surfaces is one int128 sign; in front of it stands a filter
// in doubles. Only planes evaluated at free positions (dyadic doubles) may need more, and then GMP decides. Guarantee:
// every sign is exact. Cost: a few nanoseconds in the filter, about ten in int128, a microsecond in GMP.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace findspace::exact {

using int128 = __int128;

/// A point or a vector in grid steps.
struct Grid3 {
  std::int64_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const Grid3&, const Grid3&) = default;
};

inline Grid3 operator-(const Grid3& a, const Grid3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Grid3 operator+(const Grid3& a, const Grid3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Grid3 operator-(const Grid3& a) { return {-a.x, -a.y, -a.z}; }

/// A normal vector: products of two grid differences.
struct Wide3 {
  int128 x = 0, y = 0, z = 0;
  friend bool operator==(const Wide3&, const Wide3&) = default;
  friend auto operator<=>(const Wide3&, const Wide3&) = default;
};

inline Wide3 operator-(const Wide3& a) { return {-a.x, -a.y, -a.z}; }

inline Wide3 cross(const Grid3& a, const Grid3& b) {
  return {int128(a.y) * b.z - int128(a.z) * b.y, int128(a.z) * b.x - int128(a.x) * b.z,
          int128(a.x) * b.y - int128(a.y) * b.x};
}

inline int128 dot(const Wide3& n, const Grid3& e) { return n.x * e.x + n.y * e.y + n.z * e.z; }

inline int sign(int128 value) { return (value > 0) - (value < 0); }

inline bool is_zero(const Wide3& n) { return n.x == 0 && n.y == 0 && n.z == 0; }

/// Greatest common divisor of the magnitudes; 0 only for two zeros.
int128 gcd(int128 a, int128 b);

/// `n` divided by the greatest common divisor of its components; `n` is not zero.
Wide3 primitive(const Wide3& n);

/// A double vector that approx an exact one: each component is the exact one correctly rounded.
struct Approx3 {
  double x = 0, y = 0, z = 0;
};

inline Approx3 approx(const Grid3& p) { return {double(p.x), double(p.y), double(p.z)}; }
Approx3 approx(const Wide3& n);
inline double component(const Approx3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
inline std::int64_t component(const Grid3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
inline Approx3 operator-(const Approx3& a, const Approx3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// The sign of the dot product of two approx of integer vectors, or 2 where doubles cannot tell. The grid factor is
/// exact (below 2^53), the normal has one rounding, each product one, the two sums two: the error is below 5 * 2^-53
/// times the sum of the magnitudes of the products; 2^-50 covers it and the roundings of the bound itself. Where that
/// sum is at most 2^52 everything is a small integer and nothing was rounded: ties on coarse data are decided here too.
inline int filtered_sign_dot(const Approx3& n, const Approx3& e) {
  const double a = n.x * e.x, b = n.y * e.y, c = n.z * e.z;
  const double sum = (a + b) + c;
  const double size = (std::fabs(a) + std::fabs(b)) + std::fabs(c), bound = 0x1p-50 * size;
  if (sum > bound) return 1;
  if (sum < -bound) return -1;
  if (size > 0x1p52) return 2;
  return (sum > 0) - (sum < 0);
}

/// The exact sign of n . x + d at a point of finite doubles; `n` at most 2^84, `d` at most 2^126.
int sign_plane_at(const Wide3& n, int128 d, double x, double y, double z);

/// n . x + d at a point of finite doubles, with one rounding.
double value_plane_at(const Wide3& n, int128 d, double x, double y, double z);

/// The sign of a / sqrt(p) - b / sqrt(q), where a and b are the values of two planes at one point and p and q the
/// squared lengths of their normals: which of the two planes is higher there, exactly.
int compare_planes_at(const Wide3& n, int128 d, const Wide3& m, int128 e, double x, double y, double z);

}  // namespace findspace::exact
