// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface_side.h"

#include <cmath>

namespace findspace::space {
namespace {

using exact::Real;

/// The sign of (q - p) x (x - p) seen from above.
int turn(const Point& p, const Point& q, const RealVector& x, const Vector& near) {
  const double ex = static_cast<double>(q.x - p.x), ey = static_cast<double>(q.y - p.y);
  const double a = ex * (near.y - static_cast<double>(p.y)), b = ey * (near.x - static_cast<double>(p.x));
  const double room = 0x1p-50 * (std::fabs(ex) * (std::fabs(near.y) + std::fabs(static_cast<double>(p.y))) +
                                 std::fabs(ey) * (std::fabs(near.x) + std::fabs(static_cast<double>(p.x))));
  if (a - b > room) return 1;
  if (a - b < -room) return -1;
  return (Real(q.x - p.x) * (x[1] - Real(p.y)) - Real(q.y - p.y) * (x[0] - Real(p.x))).sign();
}

std::int64_t down(double c) { return static_cast<std::int64_t>(std::floor(c)) - 1; }
std::int64_t up(double c) { return static_cast<std::int64_t>(std::ceil(c)) + 1; }

}  // namespace

std::optional<bool> encloses(const RayBody& body, const BoxTree& tree, const RealVector& point, const Vector& near) {
  const GridBox above{{down(near.x), down(near.y), down(near.z)}, {up(near.x), up(near.y), body.high.z}};
  bool inside = false;
  const bool touches = tree.any_meeting(above, [&](int f) {
    const Point &a = body.corner(f, 0), &b = body.corner(f, 1), &c = body.corner(f, 2);
    const int signs[3] = {turn(a, b, point, near), turn(b, c, point, near), turn(c, a, point, near)};
    const auto has = [&](int s) { return signs[0] == s || signs[1] == s || signs[2] == s; };
    if (has(1) && has(-1)) return false;
    if (has(0)) return true;
    const HalfSpace plane(real(body.normals[static_cast<std::size_t>(f)]),
                          -dot(real(body.normals[static_cast<std::size_t>(f)]), real(a)));
    // Seen from above the triangle turns as its normal points up or down.
    const int side = plane.sign(point, near) * (has(1) ? 1 : -1);
    if (side < 0) inside = !inside;
    return side == 0;
  });
  if (touches) return std::nullopt;
  return inside;
}

}  // namespace findspace::space
