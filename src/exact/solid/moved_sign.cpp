// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/solid/moved_sign.h"

#include <algorithm>

namespace findspace::exact {
namespace {

/// q - p: doubles, how far these may be off, and the greatest of them.
struct Way {
  double c[3];
  double error = 0, size = 0;
};

Way way(const MovedPoint& p, const MovedPoint& q, const RoughMovement& m) {
  const Grid3 d = q.at - p.at;
  const double direction = q.moved == p.moved ? 0 : q.moved ? 1 : -1;
  Way out{};
  for (int k = 0; k < 3; ++k) {
    const double whole = static_cast<double>(component(d, k)), by = direction * component(m.near, k);
    out.c[k] = whole + by;
    out.size = std::max(out.size, std::fabs(out.c[k]));
    // Of the conversion and the sum one rounding each.
    out.error = std::max(out.error, 0x1p-52 * (std::fabs(whole) + std::fabs(by)) + std::fabs(direction) * m.off);
  }
  out.size += out.error;
  return out;
}

/// A component of q - p.
Real exact_component(const MovedPoint& p, const MovedPoint& q, int axis, const Movement& m) {
  const Real whole(component(q.at, axis) - component(p.at, axis));
  if (p.moved == q.moved) return whole;
  const Real& by = m.by[static_cast<std::size_t>(axis)];
  return q.moved ? whole + by : whole - by;
}

std::array<Real, 3> exact_way(const MovedPoint& p, const MovedPoint& q, const Movement& m) {
  return {exact_component(p, q, 0, m), exact_component(p, q, 1, m), exact_component(p, q, 2, m)};
}

}  // namespace

int sign_volume(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c, const MovedPoint& d,
                const RoughMovement& m) {
  const Way u = way(a, b, m), v = way(a, c, m), w = way(a, d, m);
  const double value = (u.c[1] * v.c[2] - u.c[2] * v.c[1]) * w.c[0] + (u.c[2] * v.c[0] - u.c[0] * v.c[2]) * w.c[1] +
                       (u.c[0] * v.c[1] - u.c[1] * v.c[0]) * w.c[2];
  // Six products of three factors: by what each factor is off, and fewer than 64 roundings.
  const double bound = 8 * (u.error * v.size * w.size + u.size * v.error * w.size + u.size * v.size * w.error) +
                       0x1p-46 * u.size * v.size * w.size;
  return (value > bound) - (value < -bound);
}

int sign_volume(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c, const MovedPoint& d, const Movement& m) {
  if (a.moved == b.moved && b.moved == c.moved && c.moved == d.moved) return sign_volume(a.at, b.at, c.at, d.at);
  if (const int sign = sign_volume(a, b, c, d, m.rough); sign != 0) return sign;
  const auto e = exact_way(a, b, m), f = exact_way(a, c, m), g = exact_way(a, d, m);
  return ((e[1] * f[2] - e[2] * f[1]) * g[0] + (e[2] * f[0] - e[0] * f[2]) * g[1] + (e[0] * f[1] - e[1] * f[0]) * g[2])
      .sign();
}

int sign_turn(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c, int axis, const Movement& m) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Way u = way(a, b, m.rough), v = way(a, c, m.rough);
  const double value = u.c[i] * v.c[j] - u.c[j] * v.c[i];
  const double bound = 4 * (u.error * v.size + u.size * v.error) + 0x1p-48 * u.size * v.size;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return (exact_component(a, b, i, m) * exact_component(a, c, j, m) -
          exact_component(a, b, j, m) * exact_component(a, c, i, m))
      .sign();
}

int sign_side(const SpotPlane<MovedPoint>& plane, const MovedPoint& p, const Movement& m) {
  if (const int sign = sign_side(plane, p, m.rough); sign != 0) return sign;
  const Wide3& n = plane.normal;
  const int128 still = dot(n, p.at - plane.on.at);
  if (p.moved == plane.on.moved) return sign(still);
  const Real by = Real(n.x) * m.by[0] + Real(n.y) * m.by[1] + Real(n.z) * m.by[2];
  return (p.moved ? Real(still) + by : Real(still) - by).sign();
}

int sign_side(const SpotPlane<RaisedPoint>& plane, const RaisedPoint& p, const Fraction& by) {
  const Grid3 way = p.at - plane.on.at;
  const int low = sign_dot(plane.normal, plane.near, way);
  if (by.numerator == 0 || p.raised == plane.on.raised) return low;
  const std::int64_t up = p.raised ? 1 : -1;
  const int high = sign_dot(plane.normal, plane.near, {way.x, way.y, way.z + up});
  if (low == high) return low;  // the value is linear in the height
  return (multiply(dot(plane.normal, way), by.denominator) + multiply(plane.normal.z * up, by.numerator)).sign();
}

int compare_coordinate(const MovedPoint& a, const MovedPoint& b, int axis, const Movement& m) {
  const Way w = way(b, a, m.rough);
  if (w.c[axis] > w.error) return 1;
  if (w.c[axis] < -w.error) return -1;
  return exact_component(b, a, axis, m).sign();
}

}  // namespace findspace::exact
