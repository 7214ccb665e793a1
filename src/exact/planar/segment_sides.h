// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How two segments between grid points lie to each other, and where they cross. Guarantee: exact, in integers wide
// enough for the coordinates. Cost: six products, and a quotient. Keywords: segment intersection test, orientation.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/planar/geometry.h"

namespace findspace::exact {

/// Of the segments from p0 to p1 and from q0 to q1.
template <class Integer>
struct SegmentSides {
  // Positive where the end lies on the left of the other segment, 0 on its line.
  Integer q0, q1, p0, p1;
  bool parallel;

  /// Does a segment lie on one side of the line of the other one?
  bool apart() const { return same_side(q0, q1) || same_side(p0, p1); }

 private:
  static bool same_side(Integer k, Integer l) { return (k > 0 && l > 0) || (k < 0 && l < 0); }
};

/// Whether 64-bit integers are wide enough for segments that end at such a point.
inline bool has_narrow_sides(const Point& p) {
  constexpr double kMost = 1 << 29;
  return p.kind == Point::Kind::kGrid && std::abs(p.x) <= kMost && std::abs(p.y) <= kMost;
}

/// 128-bit integers are wide enough for |x|, |y| <= 2^60.
template <class Integer>
SegmentSides<Integer> segment_sides(const Point& p0, const Point& p1, const Point& q0, const Point& q1) {
  const std::int64_t px = p1.gx - p0.gx, py = p1.gy - p0.gy, qx = q1.gx - q0.gx, qy = q1.gy - q0.gy, x = q0.gx - p0.gx,
                     y = q0.gy - p0.gy;
  const Integer turn = Integer(px) * qy - Integer(py) * qx, of_q0 = Integer(px) * y - Integer(py) * x,
                of_p0 = Integer(qy) * x - Integer(qx) * y;
  return {of_q0, of_q0 + turn, of_p0, of_p0 - turn, turn == 0};
}

/// The crossing of the lines i and j of two such segments, one of them from p0 to p1, within an error that is simple to
/// find. With u = 2^-53 the quotient of two rounded integers is off by at most 3u, its product with a difference that
/// is no larger by 4u of that, and the sum by u of itself: together by less than 6u of the coordinate and the
/// difference.
template <class Integer>
Point rough_crossing(std::uint32_t i, std::uint32_t j, const Point& p0, const Point& p1,
                     const SegmentSides<Integer>& sides) {
  const double along = double(sides.p0) / double(sides.p0 - sides.p1);
  const double x = double(p1.gx - p0.gx), y = double(p1.gy - p0.gy);
  Point p;
  p.kind = Point::Kind::kCross;
  p.x = p0.x + along * x;
  p.y = p0.y + along * y;
  p.error = std::max(std::abs(p0.x) + std::abs(x), std::abs(p0.y) + std::abs(y)) * (8 * Approx::kUnit);
  p.i = std::min(i, j);
  p.j = std::max(i, j);
  return p;
}

}  // namespace findspace::exact
