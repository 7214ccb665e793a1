// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "distance/planar_features/level_curve.h"

namespace findspace::distance {
namespace distance_level_curve {

using exact::Real;
using exact::RealPoint;

bool has_level(const std::vector<Event>& all, const Real& level) {
  for (const Event& e : all)
    if (e.level == level) return true;
  return false;
}

TEST(LevelCurve, CircleVanishes) {
  auto all = events(LevelCurve::ring(1, 2, -3, 1));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].level, Real(3));
  EXPECT_TRUE(events(LevelCurve::line(1, 0, 2, 1)).empty());
}

TEST(LevelCurve, TwoPointsMeetHalfWay) {
  auto all = events(LevelCurve::ring(0, 0, 0, 1), LevelCurve::ring(6, 8, 0, 1));
  EXPECT_TRUE(has_level(all, Real(5)));
}

TEST(LevelCurve, WallsOfACorridor) {
  // x = level from the left wall x = 0, x = 7 - level from the right one.
  auto all = events(LevelCurve::line(1, 0, 0, 1), LevelCurve::line(1, 0, 7, -1));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].level, Real::ratio(7, 2));
  EXPECT_FALSE(all[0].at);
}

TEST(LevelCurve, CircumscribedCircle) {
  auto all = events(LevelCurve::ring(0, 0, 0, 1), LevelCurve::ring(4, 0, 0, 1), LevelCurve::ring(0, 3, 0, 1));
  EXPECT_TRUE(has_level(all, Real::ratio(5, 2)));
}

TEST(LevelCurve, InscribedCircleOfA345Triangle) {
  auto all = events(LevelCurve::line(1, 0, 0, 1), LevelCurve::line(0, 1, 0, 1), LevelCurve::line(3, 4, 12, -5));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].level, Real(1));
}

TEST(LevelCurve, BetweenAPointAndALineOnAStillLine) {
  // On x = 3, equally far from (0, 0) and y = 9: y = 4, level 5.
  auto all = events(LevelCurve::line(1, 0, 3, 0), LevelCurve::ring(0, 0, 0, 1), LevelCurve::line(0, 1, 9, -1));
  EXPECT_TRUE(has_level(all, Real(5)));
}

TEST(LevelCurve, TwoPointsOnAStillCircle) {
  // On the circle of radius 5 about 0, equally far from (3, 3) and (5, 3): (4, +-3); distances 1 and sqrt 37.
  auto all = events(LevelCurve::ring(0, 0, 5, 0), LevelCurve::ring(3, 3, 0, 1), LevelCurve::ring(5, 3, 0, 1));
  EXPECT_TRUE(has_level(all, Real(1)));
  EXPECT_TRUE(has_level(all, sqrt(Real(37))));
}

TEST(LevelCurve, Moved) {
  LevelCurve f = LevelCurve::line(1, 1, 5, 2).moved(RealPoint{1, 2});
  EXPECT_EQ(f.c, Real(2));
  LevelCurve g = LevelCurve::ring(1, 1, 0, 1).moved(RealPoint{1, 2});
  EXPECT_EQ(g.b, Real(-1));
}

}  // namespace distance_level_curve
}  // namespace findspace::distance
