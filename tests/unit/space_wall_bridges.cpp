// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets across the walls between parts: within the union, and about every place of walls that meet squarely.
#include <gtest/gtest.h>

#include <algorithm>

#include "space/body/wall_bridges.h"

namespace findspace::space {
namespace space_wall_bridges {

using exact::Real;

BodyPart box(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (const std::int64_t x : {low.x, high.x})
    for (const std::int64_t y : {low.y, high.y})
      for (const std::int64_t z : {low.z, high.z}) corners.push_back({x, y, z});
  return part_of(corners, Real());
}

bool inside(const WallBridge& set, const RealVector& p) {
  return std::all_of(set.planes.begin(), set.planes.end(), [&](const HalfSpace& h) { return h.value(p).sign() < 0; });
}

bool inside_one(const std::vector<WallBridge>& sets, const RealVector& p) {
  return std::any_of(sets.begin(), sets.end(), [&](const WallBridge& s) { return inside(s, p); });
}

TEST(WallBridges, OfAnL) {
  const Body body{{box({0, 0, 0}, {10, 5, 4}), box({0, 5, 0}, {5, 10, 4})}};
  const std::vector<WallBridge> sets = wall_bridges(body);
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0].planes.size(), 6u);
  EXPECT_TRUE(inside(sets[0], {Real(1), Real(5), Real(1)}));
  EXPECT_TRUE(inside(sets[0], {Real(4), Real(1), Real(3)}));
  EXPECT_FALSE(inside(sets[0], {Real(5), Real(5), Real(1)}));  // on the inner edge
  EXPECT_FALSE(inside(sets[0], {Real(6), Real(3), Real(1)}));
}

TEST(WallBridges, OfFourPartsAboutAnEdge) {
  const Body body{
      {box({0, 0, 0}, {5, 5, 4}), box({5, 0, 0}, {10, 5, 4}), box({0, 5, 0}, {5, 10, 4}), box({5, 5, 0}, {10, 10, 4})}};
  EXPECT_TRUE(inside_one(wall_bridges(body), {Real(5), Real(5), Real(2)}));
}

TEST(WallBridges, NoneWhereNoFacesMeet) {
  const Body apart{{box({0, 0, 0}, {5, 5, 4}), box({6, 0, 0}, {10, 5, 4})}};
  EXPECT_TRUE(wall_bridges(apart).empty());
  const Body at_an_edge{{box({0, 0, 0}, {5, 5, 4}), box({5, 5, 0}, {10, 10, 4})}};
  EXPECT_TRUE(wall_bridges(at_an_edge).empty());
  const Body overlapping{{box({0, 0, 0}, {6, 5, 4}), box({5, 0, 0}, {10, 5, 4})}};
  EXPECT_TRUE(wall_bridges(overlapping).empty());
}

}  // namespace space_wall_bridges
}  // namespace findspace::space
