// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of convex sets with a stretch of a line, of sets of every dimension, against the definition on a lattice; the
// dimension of a region that is cut where it only touches.
#include <gtest/gtest.h>

#include <optional>

#include "space/rays/swept_pieces.h"

namespace findspace::space {
namespace {

using exact::Real;

RealVector vec(int x, int y, int z) { return {Real(x), Real(y), Real(z)}; }
HalfSpace half(int x, int y, int z, int offset) { return HalfSpace(vec(x, y, z), Real(offset)); }

ConvexRegion region(std::initializer_list<HalfSpace> cuts) {
  ConvexRegion out(vec(-2, -2, -2), vec(2, 2, 2));
  for (const HalfSpace& h : cuts) out.cut(h);
  return out;
}

/// Whether x - s way lies in the set for an s of the stretch.
bool in_sum(const ConvexRegion& set, const Sweep& sweep, const RealVector& x) {
  Real from = sweep.from, to = sweep.to;
  for (const HalfSpace& h : set.planes()) {
    const Real slope = -dot(h.normal, sweep.way), value = h.value(x);
    if (slope.sign() == 0 && value.sign() > 0) return false;
    if (slope.sign() > 0) to = std::min(to, -value / slope);
    if (slope.sign() < 0) from = std::max(from, -value / slope);
  }
  return from <= to;
}

void expect_sum(const ConvexRegion& set, const RealVector& way) {
  const Sweep sweep{way, Real::ratio(-1, 2), Real(1)};
  const LinePiece piece = swept_piece(set, sweep);
  for (const HalfSpace& h : piece.planes) ASSERT_FALSE(is_zero(h.normal));
  for (int k = 0; k < 17 * 17 * 17; ++k) {
    const RealVector x{Real::ratio(k % 17 - 8, 2), Real::ratio(k / 17 % 17 - 8, 2), Real::ratio(k / 289 - 8, 2)};
    bool held = true;
    for (const HalfSpace& h : piece.planes) held = held && h.value(x).sign() <= 0;
    ASSERT_EQ(held, in_sum(set, sweep, x)) << k;
  }
}

TEST(SweptPieces, SetsOfEveryDimension) {
  const HalfSpace up = half(1, 1, 1, -1), down = half(-1, -1, -1, 1);
  const ConvexRegion sets[] = {
      region({up}),                                                      // a body
      region({up, down}),                                                // a polygon that most ways cross
      region({half(0, 0, 1, 0), half(0, 0, -1, 0), half(1, 2, 0, -3)}),  // one in a plane that some hold
      region({up, down, half(1, -1, 0, 0), half(-1, 1, 0, 0)}),          // a segment
      region({half(-1, -1, -1, 6)}),                                     // a corner
      region({half(0, -1, -1, 4)}),                                      // an edge of the box
      region({half(1, 1, 0, -2), half(1, 0, 1, -2), half(1, 1, 1, -3), half(0, 1, 1, -2)})};  // touched at corners
  const RealVector ways[] = {vec(1, 0, 0), vec(1, 1, 0), vec(1, 2, 3), vec(1, -1, 0), vec(-2, 1, 1)};
  for (const ConvexRegion& set : sets) {
    for (const RealVector& way : ways) expect_sum(set, way);
  }
}

TEST(SweptPieces, DimensionOfWhatTouches) {
  EXPECT_EQ(region({}).dimension(), 3);
  EXPECT_EQ(region({half(-1, -1, -1, 6)}).dimension(), 0);
  EXPECT_EQ(region({half(0, -1, -1, 4)}).dimension(), 1);
  EXPECT_EQ(region({half(0, 0, -1, 2)}).dimension(), 2);
  EXPECT_EQ(region({half(0, 0, -1, 3)}).dimension(), -1);
  EXPECT_EQ(region({half(1, 1, 1, -1), half(-1, -1, -1, 1)}).dimension(), 2);
  EXPECT_EQ(ConvexRegion(vec(0, 0, 0), vec(1, 1, 0)).dimension(), 2);
  EXPECT_EQ(ConvexRegion(vec(0, 0, 0), vec(1, 0, 0)).dimension(), 1);
}

}  // namespace
}  // namespace findspace::space
