// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How two segments between grid points lie to each other. Guarantee: exact, for |x|, |y| <= 2^60. Cost: six products.
// Keywords: segment intersection test, orientation.
#pragma once

#include "exact/planar/geometry.h"

namespace findspace::exact {

/// Of the segments from p0 to p1 and from q0 to q1.
struct SegmentSides {
  int q0, q1;  // +1 where an end of q lies on the left of p, 0 on its line
  int p0, p1;  // the same of the ends of p and the line of q
  bool parallel;
};

inline SegmentSides segment_sides(const Point& p0, const Point& p1, const Point& q0, const Point& q1) {
  const std::int64_t px = p1.gx - p0.gx, py = p1.gy - p0.gy, qx = q1.gx - q0.gx, qy = q1.gy - q0.gy, x = q0.gx - p0.gx,
                     y = q0.gy - p0.gy;
  const int128 turn = int128(px) * qy - int128(py) * qx, first = int128(px) * y - int128(py) * x,
               second = int128(qy) * x - int128(qx) * y;
  const auto sign = [](int128 k) { return (k > 0) - (k < 0); };
  return {sign(first), sign(first + turn), sign(second), sign(second - turn), turn == 0};
}

}  // namespace findspace::exact
