// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact signs of corners of two bodies, one of which stands at any real position: what ray_sign.h tells of positions on
// rays; of both kinds, the side of a plane with a known normal. Guarantee: every sign is exact. Cost: a filter in
// doubles, some microseconds where it fails. Keywords: orientation test, floating point filter.
#pragma once

#include <array>

#include "exact/solid/ray_sign.h"

namespace findspace::exact {

/// A movement that is known in doubles only, each component off by at most that.
struct RoughMovement {
  Approx3 near;
  double off = 0;
};

/// By what the moved body stands elsewhere.
struct Movement {
  std::array<Real, 3> by;
  RoughMovement rough;
  explicit Movement(std::array<Real, 3> p)
      : by(std::move(p)), rough{{by[0].to_double(), by[1].to_double(), by[2].to_double()}} {
    rough.off =
        0x1p-52 * std::fmax(std::fabs(rough.near.x), std::fmax(std::fabs(rough.near.y), std::fabs(rough.near.z)));
  }
};

/// A corner of one of two bodies where it stands in its own.
struct MovedPoint {
  Grid3 at;
  bool moved = false;
};

/// As in ray_sign.h.
int sign_volume(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c, const MovedPoint& d, const Movement& m);
/// 0 where the movement does not tell.
int sign_volume(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c, const MovedPoint& d,
                const RoughMovement& m);
int sign_turn(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c, int axis, const Movement& m);
int compare_coordinate(const MovedPoint& a, const MovedPoint& b, int axis, const Movement& m);

/// The plane of three corners of a body: one of them, and the normal that sign_volume takes them for.
template <class Spot>
struct SpotPlane {
  Spot on;
  const Wide3& normal;
  const Approx3& near;  // the normal rounded
};

/// Which side of the plane p is on: + that of the normal. As sign_volume, for a fraction of its cost.
int sign_side(const SpotPlane<RaisedPoint>& plane, const RaisedPoint& p, const Fraction& by);
int sign_side(const SpotPlane<MovedPoint>& plane, const MovedPoint& p, const Movement& m);
/// 0 where the movement does not tell.
inline int sign_side(const SpotPlane<MovedPoint>& plane, const MovedPoint& p, const RoughMovement& m) {
  const Approx3 &n = plane.near, d = approx(p.at - plane.on.at);
  const double moved = double(p.moved) - double(plane.on.moved);
  const double value = n.x * (d.x + moved * m.near.x) + n.y * (d.y + moved * m.near.y) + n.z * (d.z + moved * m.near.z);
  const auto sum = [](const Approx3& v) { return (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z); };
  // Of a component of the way two roundings and the movement's; of the normal, the products and the sums five more.
  const double bound = sum(n) * (0x1p-49 * (sum(d) + sum(m.near)) + m.off);
  return (value > bound) - (value < -bound);
}

}  // namespace findspace::exact
