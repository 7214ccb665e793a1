// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// World::solve and solve_bounds of sums of distances and of distances compared, against values that are computed here,
// in doubles, from the definition of the distance to a box, a disc and a point.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "findspace/findspace.h"

namespace io_public_sums {

using namespace findspace;

constexpr double kClose = 1e-7;  // of values in doubles: what is nearer to the level is not looked at

/// The signed distance of a point to a box about (x, y).
double to_box(const Position& p, double x, double y, double wide, double high) {
  const double dx = std::abs(p[0] - x) - wide, dy = std::abs(p[1] - y) - high;
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0);
}
double to_disc(const Position& p, double x, double y, double r) { return std::hypot(p[0] - x, p[1] - y) - r; }
double to_a(const Position& p) { return to_box(p, -3, 1, 2, 1); }
double to_c(const Position& p) { return to_disc(p, 4, -1, 1.5); }

/// B is a point, so that a position is what its distance is from.
World world() {
  return World({{"A", Shape::box({-5, 0}, {-1, 2})},
                {"C", Shape::disc({4, -1}, 1.5)},
                {"P", Shape::points({{-3, 0}})},
                {"Q", Shape::points({{3, 0}})},
                {"W", Shape::box({-12, -12}, {12, 12})},
                {"B", Shape::points({{0, 0}})}},
               "B");
}

std::vector<Position> places(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-11.9, 11.9);
  std::vector<Position> out(count);
  for (Position& p : out) p = {at(random), at(random)};
  return out;
}

std::vector<char> inside(const Region& region, const std::vector<Position>& at) {
  std::vector<char> out;
  for (const Position& p : at) out.push_back(region.contains(p));
  return out;
}

/// `excess`: not above 0 exactly where the formula holds.
void expect_bounds(const Formula& formula, const std::function<double(const Position&)>& excess, double gap) {
  const std::vector<Position> at = places(4000);
  const RegionBounds found = world().solve_bounds(formula);
  const std::vector<char> inner = inside(found.inner, at), outer = inside(found.outer, at);
  int open = 0, holds = 0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double f = excess(at[k]);
    open += inner[k] != outer[k];
    holds += f <= 0;
    if (std::abs(f) < kClose) continue;
    EXPECT_TRUE(f <= 0 || !inner[k]) << at[k][0] << ", " << at[k][1] << ": " << f;
    EXPECT_TRUE(f > 0 || outer[k]) << at[k][0] << ", " << at[k][1] << ": " << f;
    EXPECT_TRUE(std::abs(f) < gap || inner[k] == outer[k]) << at[k][0] << ", " << at[k][1] << ": " << f;
  }
  EXPECT_GT(holds, 100);
  EXPECT_LT(holds, 3900);
  EXPECT_LT(open, 40);
}

/// Where the curve is made of lines and circles the region is exact.
void expect_exact(const Formula& formula, const std::function<double(const Position&)>& excess) {
  const std::vector<Position> at = places(4000);
  const std::vector<char> found = inside(world().solve(formula), at);
  int holds = 0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double f = excess(at[k]);
    holds += f <= 0;
    if (std::abs(f) > kClose) {
      EXPECT_EQ(f <= 0, bool(found[k])) << at[k][0] << ", " << at[k][1] << ": " << f;
    }
  }
  EXPECT_GT(holds, 100);
  EXPECT_LT(holds, 3900);
}

TEST(PublicSums, WeightedSumBelowALevel) {
  expect_bounds(
      "gap(B, A) + 2 * gap(B, C) <= 14 and inside(B, W)", [](const Position& p) { return to_a(p) + 2 * to_c(p) - 14; },
      0.5);
}

TEST(PublicSums, SumAboveALevelAndAPlainCondition) {
  expect_bounds(
      "gap(B, A) + gap(B, C) >= 9 and inside(B, W) and gap(B, C) >= 2",
      [](const Position& p) { return std::max(9 - to_a(p) - to_c(p), 2 - to_c(p)); }, 0.5);
}

TEST(PublicSums, BoxAndDiscCompared) {
  expect_bounds(
      "gap(B, A) <= gap(B, C) and inside(B, W)", [](const Position& p) { return to_a(p) - to_c(p); }, 0.5);
}

TEST(PublicSums, NearerOfTwoPointsIsAHalfPlane) {
  expect_exact("gap(B, P) <= gap(B, Q) and inside(B, W)",
               [](const Position& p) { return to_disc(p, -3, 0, 0) - to_disc(p, 3, 0, 0); });
}

TEST(PublicSums, TwiceAsNearIsADisc) {
  expect_exact("2 * gap(B, P) <= gap(B, Q) and inside(B, W)",
               [](const Position& p) { return 2 * to_disc(p, -3, 0, 0) - to_disc(p, 3, 0, 0); });
}

TEST(PublicSums, SolveRefusesWhatItKnowsBetweenBoundsOnly) {
  EXPECT_THROW(world().solve("gap(B, A) + 2 * gap(B, C) <= 14 and inside(B, W)"), Error);
}

TEST(PublicSums, ABestPositionOnACurveKnownBetweenBoundsIsUndecided) {
  // A branch of a hyperbola, |p - C| - |p - A| = 2, with the vertex (1, 0).
  const auto answer = [](const std::string& where, const std::string& rest) {
    return Scene::json(R"json({"findspace": 1, "shapes": {"A": {"disc": {"center": [6, 0], "radius": 1}},
      "C": {"disc": {"center": [-6, 0], "radius": 3}}, "W": {"box": {"min": [-20, -20], "max": [20, 20]}},
      "B": {"points": [[0, 0]]}}, "moving": "B", "minimize": "x", "where": "inside(B, W) and )json" +
                       where + "\"" + rest + "}")
        .map();
  };
  const char* const line = R"json(, "free": {"line": {"through": [0, 1], "direction": [1, 0]}})json";
  for (const char* rest : {"", line}) {
    const Answer curve = answer("gap(B, A) = gap(B, C)", rest);
    ASSERT_TRUE(curve.region()->inner.empty());
    EXPECT_EQ(curve.found(), Answer::Found::kUndecided);
    EXPECT_NE(curve.text().find("none certain"), std::string::npos) << curve.text();
    EXPECT_EQ(curve.text().find("there is none"), std::string::npos);
    EXPECT_EQ(answer("gap(B, A) <= -2", rest).found(), Answer::Found::kNo);
  }
}

TEST(PublicSums, OneDistanceFallsWithoutEnd) {
  // H has no end; the hole in it is a square of 9.
  const World w({{"A", Shape::box({2, 1}, {5, 4})},
                 {"H", Shape::complement(Shape::box({0, 0}, {9, 9}))},
                 {"B", Shape::points({{0, 0}})}},
                "B");
  const Optimum least = w.minimize("3 * gap(B, A) + gap(B, H)");
  ASSERT_TRUE(least.value);
  EXPECT_NEAR(*least.value, -2, 1e-2);  // in the middle of A
  EXPECT_LE(least.lower, -2 + kClose);
  const Answer greatest = Scene::json(R"json({"findspace": 1, "shapes": {"A": {"box": {"min": [2, 1], "max": [5, 4]}},
    "H": {"complement": {"box": {"min": [0, 0], "max": [9, 9]}}}, "B": {"points": [[0, 0]]}}, "moving": "B",
    "where": "true", "maximize": "-3 * gap(B, A) - gap(B, H)"})json")
                              .map();
  ASSERT_TRUE(greatest.best() && greatest.best()->value);
  EXPECT_NEAR(*greatest.best()->value, 2, 1e-2);
  EXPECT_TRUE(w.minimize("gap(B, A) + 3 * gap(B, H)").unbounded);
  EXPECT_TRUE(w.minimize("-3 * gap(B, A) - gap(B, H)").unbounded);
  EXPECT_THROW(w.minimize("gap(B, A) + gap(B, H)"), Error);
}

TEST(PublicSums, HoldsAtAPositionIsTheSign) {
  const World w = world();
  for (const Position& p : places(300)) {
    const double f = to_a(p) + 2 * to_c(p) - 14;
    if (std::abs(f) > kClose) {
      EXPECT_EQ(w.holds("gap(B, A) + 2 * gap(B, C) <= 14", {p[0], p[1]}), f <= 0);
    }
  }
}

}  // namespace io_public_sums
