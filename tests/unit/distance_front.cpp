// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "distance/planar_features/front.h"

namespace findspace::distance {
namespace {

using exact::Real;
using exact::RealPoint;

bool has_level(const std::vector<Event>& all, const Real& level) {
  for (const Event& e : all)
    if (e.level == level) return true;
  return false;
}

TEST(Front, CircleVanishes) {
  auto all = events(Front::ring(1, 2, -3, 1));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].level, Real(3));
  EXPECT_TRUE(events(Front::line(1, 0, 2, 1)).empty());
}

TEST(Front, TwoPointsMeetHalfWay) {
  auto all = events(Front::ring(0, 0, 0, 1), Front::ring(6, 8, 0, 1));
  EXPECT_TRUE(has_level(all, Real(5)));
}

TEST(Front, WallsOfACorridor) {
  // x = level from the left wall x = 0, x = 7 - level from the right one.
  auto all = events(Front::line(1, 0, 0, 1), Front::line(1, 0, 7, -1));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].level, Real::ratio(7, 2));
  EXPECT_FALSE(all[0].at);
}

TEST(Front, CircumscribedCircle) {
  auto all = events(Front::ring(0, 0, 0, 1), Front::ring(4, 0, 0, 1), Front::ring(0, 3, 0, 1));
  EXPECT_TRUE(has_level(all, Real::ratio(5, 2)));
}

TEST(Front, InscribedCircleOfA345Triangle) {
  auto all = events(Front::line(1, 0, 0, 1), Front::line(0, 1, 0, 1), Front::line(3, 4, 12, -5));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].level, Real(1));
}

TEST(Front, BetweenAPointAndALineOnAStillLine) {
  // On x = 3, equally far from (0, 0) and y = 9: y = 4, level 5.
  auto all = events(Front::line(1, 0, 3, 0), Front::ring(0, 0, 0, 1), Front::line(0, 1, 9, -1));
  EXPECT_TRUE(has_level(all, Real(5)));
}

TEST(Front, TwoPointsOnAStillCircle) {
  // On the circle of radius 5 about 0, equally far from (3, 3) and (5, 3): (4, +-3); distances 1 and sqrt 37.
  auto all = events(Front::ring(0, 0, 5, 0), Front::ring(3, 3, 0, 1), Front::ring(5, 3, 0, 1));
  EXPECT_TRUE(has_level(all, Real(1)));
  EXPECT_TRUE(has_level(all, sqrt(Real(37))));
}

TEST(Front, Moved) {
  Front f = Front::line(1, 1, 5, 2).moved(RealPoint{1, 2});
  EXPECT_EQ(f.c, Real(2));
  Front g = Front::ring(1, 1, 0, 1).moved(RealPoint{1, 2});
  EXPECT_EQ(g.b, Real(-1));
}

}  // namespace
}  // namespace findspace::distance
