// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact signs of corners of two bodies, one of which stands at any real position: what ray_sign.h tells of positions on
// rays. Guarantee: every sign is exact. Cost: a filter in doubles, some microseconds where it fails. Keywords:
// orientation test, floating point filter.
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

}  // namespace findspace::exact
