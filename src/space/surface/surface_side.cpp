// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/surface_side.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"

namespace findspace::space {
namespace {

using exact::Real;

/// The sign of (q - p) x (x - p) seen from above.
int turn(const Point& p, const Point& q, const RealVector& x, const Vector& near) {
  const double ex = static_cast<double>(q.x - p.x), ey = static_cast<double>(q.y - p.y);
  const double a = ex * (near.y - static_cast<double>(p.y)), b = ey * (near.x - static_cast<double>(p.x));
  const double tolerance =
      margin::kRoundings8 * (std::fabs(ex) * (std::fabs(near.y) + std::fabs(static_cast<double>(p.y))) +
                             std::fabs(ey) * (std::fabs(near.x) + std::fabs(static_cast<double>(p.x))));
  if (a - b > tolerance) return 1;
  if (a - b < -tolerance) return -1;
  return (Real(q.x - p.x) * (x[1] - Real(p.y)) - Real(q.y - p.y) * (x[0] - Real(p.x))).sign();
}

/// The same where the point is displaced to the right and, less, upward; 0 only for p and q one above the other.
int displaced(int turn, const Point& p, const Point& q) {
  if (turn != 0) return turn;
  return p.y != q.y ? (p.y > q.y ? 1 : -1) : (q.x > p.x) - (q.x < p.x);
}

/// Whether the point, which is in the plane of the face, is on it.
bool on_face(const RayBody& body, std::size_t f, const RealVector& point) {
  const RealVector normal = real(body.normals[f]);
  for (int k = 0; k < 3; ++k) {
    const Point &a = body.corner(static_cast<int>(f), k), &b = body.corner(static_cast<int>(f), (k + 1) % 3);
    if (dot(cross(normal, real(b - a)), minus(point, real(a))).sign() < 0) return false;
  }
  return true;
}

std::int64_t down(double c) { return static_cast<std::int64_t>(std::floor(c)) - 1; }
std::int64_t up(double c) { return static_cast<std::int64_t>(std::ceil(c)) + 1; }

bool beside(const RayBody& body, const Vector& near) {
  const Vector low = exact::approx(body.low), high = exact::approx(body.high);
  return near.x < low.x - 1 || near.x > high.x + 1 || near.y < low.y - 1 || near.y > high.y + 1 || near.z < low.z - 1 ||
         near.z > high.z + 1;
}

}  // namespace

SurfaceSide side_of(const RayBody& body, const BoxTree& tree, const RealVector& point, const Vector& near) {
  if (beside(body, near)) return SurfaceSide::kOutside;
  const GridBox above{{down(near.x), down(near.y), down(near.z)}, {up(near.x), up(near.y), body.high.z}};
  int sum = 0;
  const bool on = tree.any_meeting(above, [&](int face) {
    const std::size_t f = static_cast<std::size_t>(face);
    const Point &a = body.corner(face, 0), &b = body.corner(face, 1), &c = body.corner(face, 2);
    const int ab = turn(a, b, point, near), bc = turn(b, c, point, near), ca = turn(c, a, point, near);
    if (std::max({ab, bc, ca}) > 0 && std::min({ab, bc, ca}) < 0) return false;
    const RealVector normal = real(body.normals[f]);
    const int side = HalfSpace(normal, -dot(normal, real(a))).sign(point, near);
    if (side == 0 && on_face(body, f, point)) return true;
    const int look = exact::sign(body.normals[f].z);
    if (look == 0 || side != -look) return false;
    if (displaced(ab, a, b) == look && displaced(bc, b, c) == look && displaced(ca, c, a) == look) sum += look;
    return false;
  });
  return on ? SurfaceSide::kOn : sum > 0 ? SurfaceSide::kInside : SurfaceSide::kOutside;
}

}  // namespace findspace::space
