// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "distance/planar_features/curved_level_curve.h"

namespace findspace::distance {
namespace distance_curved_level_curve {

using exact::Real;

/// Between the point (0, 0) and the line y = 2 above it: at a level the place (sqrt(4 level - 4), 2 - level) on the
/// right. On the line x = 0 moved by p where p.x is the place's x.
LevelCurve parabola(const Real& scale = 1) {
  const auto f = corner_level_curve(LevelCurve::line(scale, 0, 0, 0), LevelCurve::ring(0, 0, 0, 1),
                                    LevelCurve::line(0, 1, 2, -1), 5, 0);
  return *f;
}

std::vector<Real> levels(const LevelCurve& f, const LevelCurve& g) { return curved_levels(std::array{&f, &g}, 0, 100); }
std::vector<Real> levels(const LevelCurve& f, const LevelCurve& g, const LevelCurve& h) {
  return curved_levels(std::array{&f, &g, &h}, 0, 100);
}

TEST(CurvedLevelCurve, IsALineInItsPlace) {
  const auto all = levels(parabola(), LevelCurve::line(2, 0, 8, 0));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0], Real(5));
  EXPECT_TRUE(levels(parabola(), LevelCurve::line(1, 0, -4, 0)).empty());  // that is the other side
  EXPECT_TRUE(levels(parabola(), LevelCurve::line(0, 1, 4, 0)).empty());
}

TEST(CurvedLevelCurve, IsAnotherBentLine) {
  // sqrt(4 l - 4) = 8 - sqrt(9 l - 9).
  LevelCurve g = LevelCurve::line(1, 0, 8, 0);
  g.bend = std::make_shared<Bend>(Bend{-1, {-9, 9, 0}, {}, {}});
  const auto all = levels(parabola(), g);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0], Real::ratio(89, 25));
}

TEST(CurvedLevelCurve, TouchesACircle) {
  // 10 - sqrt(4 l - 4) = l.
  const auto all = levels(parabola(), LevelCurve::ring(10, 0, 0, 1));
  ASSERT_GE(all.size(), 1u);
  EXPECT_EQ(all[0], Real(12) - sqrt(Real(40)));
}

TEST(CurvedLevelCurve, MeetsTwoLines) {
  // y = level and x + y = 8: sqrt(4 l - 4) + l = 8.
  for (const int scale : {1, 3}) {
    const auto all = levels(parabola(scale), LevelCurve::line(0, 1, 0, 1), LevelCurve::line(1, 1, 8, 0));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0], Real(10) - sqrt(Real(32)));
  }
}

TEST(CurvedLevelCurve, MeetsALineAndACircle) {
  const auto all = levels(parabola(), LevelCurve::line(0, 1, 3, 0), LevelCurve::ring(1, 0, 0, 1));
  ASSERT_EQ(all.size(), 1u);
  const Real &l = all[0], x = sqrt(Real(4) * l - Real(4)) - Real(1);
  EXPECT_EQ((x * x + Real(9) - l * l).sign(), 0);
}

TEST(CurvedLevelCurve, MeetsTwoCircles) {
  const auto all = levels(parabola(), LevelCurve::ring(1, 0, 0, 1), LevelCurve::ring(0, 7, 1, 1));
  ASSERT_GE(all.size(), 1u);
  const Real &l = all[0], x = sqrt(Real(4) * l - Real(4));
  // The difference of the circles' equations: 2x - 14y + 48 = 2l + 1.
  const Real y = (Real(2) * x + Real(47) - Real(2) * l) / Real(14);
  const Real near = (x - Real(1)) * (x - Real(1)) + y * y - l * l;
  EXPECT_NEAR(near.to_double(), 0, 1e-9);
}

TEST(CurvedLevelCurve, TwoThatAreBentAlike) {
  // Mirrored ones, x = sqrt(4 l - 4) and y = sqrt(4 l - 4), and a circle about the origin of radius |l - 2|.
  LevelCurve g = parabola();
  std::swap(g.a, g.b);
  const auto all = levels(parabola(), g, LevelCurve::ring(0, 0, -2, 1));
  ASSERT_EQ(all.size(), 2u);
  for (const Real& l : all) EXPECT_EQ((Real(8) * l - Real(8) - (l - Real(2)) * (l - Real(2))).sign(), 0);
}

/// The same place on a circle about (3, 0) of radius 2 moved by p: a circle of radius 2 about the place less (3, 0).
LevelCurve on_an_arc() {
  return *corner_level_curve(LevelCurve::ring(3, 0, 2, 0), LevelCurve::ring(0, 0, 0, 1), LevelCurve::line(0, 1, 2, -1),
                             5, 0);
}

TEST(CurvedLevelCurve, AnArcsIsACircleThatMoves) {
  // About (sqrt(4 l - 4) - 3, 2 - l), radius 2; at level 5 about (1, -3).
  EXPECT_NEAR(on_an_arc().gap(3, -3, 5), 0, 1e-12);
  EXPECT_NEAR(on_an_arc().gap(1, 0, 5), 1, 1e-12);
  EXPECT_NEAR(on_an_arc().moved({1, 0}).gap(2, -3, 5), 0, 1e-12);
  EXPECT_NEAR(on_an_arc().reflected().gap(-3, 3, 5), 0, 1e-12);
  EXPECT_NEAR(parabola().gap(1, 7, 5), 3, 1e-12);
}

TEST(CurvedLevelCurve, AnArcsTouchesALine) {
  // y = -1 - level above it and the circle's top 4 - level never meet; y = 4 - 2 level does at 0, x = 3 at level 5.
  const auto all = levels(on_an_arc(), LevelCurve::line(1, 0, 3, 0));
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Real& l) { return l == Real(5); }));
  EXPECT_TRUE(levels(on_an_arc(), LevelCurve::line(0, 1, -1, -1)).empty());
}

TEST(CurvedLevelCurve, AnArcsTouchesACircle) {
  // About (-3, 2) of radius level: 4 l - 4 + l^2 = (l + 2)^2 never, = (l - 2)^2 at level 1.
  const auto all = levels(on_an_arc(), LevelCurve::ring(-3, 2, 0, 1));
  ASSERT_FALSE(all.empty());
  for (const Real& l : all) EXPECT_EQ(l, Real(1));
}

TEST(CurvedLevelCurve, AnArcsMeetsTwoLines) {
  // Through (1, level - 8): (sqrt(4 l - 4) - 4)^2 + (10 - 2 l)^2 = 4.
  const auto all = levels(on_an_arc(), LevelCurve::line(1, 0, 1, 0), LevelCurve::line(0, 1, -8, 1));
  for (const Real& l : all) {
    const Real x = sqrt(Real(4) * l - Real(4)) - Real(4), y = Real(10) - Real(2) * l;
    EXPECT_EQ((x * x + y * y - Real(4)).sign(), 0);
  }
  EXPECT_EQ(all.size(), 2u);
}

TEST(CurvedLevelCurve, TwoThatAreBentOtherwise) {
  // sqrt(4 l - 4) = 8 - sqrt(9 l - 9) again, x + 0 y both, and y = 0: three lines through one point.
  LevelCurve g = LevelCurve::line(1, 1, 8, 0);
  g.bend = std::make_shared<Bend>(Bend{-1, {-9, 9, 0}, {}, {}});
  const auto all = levels(parabola(), g, LevelCurve::line(0, 1, 0, 0));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0], Real::ratio(89, 25));
}

}  // namespace distance_curved_level_curve
}  // namespace findspace::distance
