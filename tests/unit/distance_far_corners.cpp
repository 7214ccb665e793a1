// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The farthest corners of solids against all pairs, and the corner farthest from a convex set against what the distance
// of all corners says.
#include <gtest/gtest.h>

#include <random>

#include "distance/search/solid_protrusion.h"
#include "distance/solid/far_corners.h"
#include "distance/surface/outline.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_far_corners {

using exact::Real;
using space::Body;
using space::place;
using space::Point;
using space::RealVector;

std::vector<Point> random_points(std::mt19937& random, int count, int size) {
  const auto pick = [&] { return std::uniform_int_distribution<int>(-size, size)(random); };
  std::vector<Point> out;
  for (int k = 0; k < count; ++k) out.push_back({pick(), pick(), pick()});
  return out;
}

Real farthest_of_all(const std::vector<Corners>& b, const std::vector<Corners>& a, const RealVector& p) {
  Real best;
  for (const Corners& s : b) {
    for (const Point& w : s.points) {
      for (const Corners& t : a) {
        for (const Point& v : t.points) {
          const RealVector e = space::minus(space::real(v), space::plus(space::real(w), p));
          const Real value = sqrt(space::dot(e, e)) + s.radius + t.radius;
          if (best < value) best = value;
        }
      }
    }
  }
  return best;
}

TEST(FarCorners, AreTheFarthestOfAllPairs) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    const int size = round % 3 == 0 ? 2 : 30;  // small: many pairs are equally far
    const auto v = random_points(random, 1 + round % 20, size), w = random_points(random, 1 + round % 7, size),
               u = random_points(random, 3, 2 * size);
    const std::vector<Corners> a{{v, Real()}, {u, Real(round % 4)}}, b{{w, Real(round % 2)}};
    const RealVector p = place(round, -3 * round, 7, 2);
    const Real wanted = farthest_of_all(b, a, p);
    const Answer found = farthest_apart(b, a, p);
    ASSERT_EQ((found.value - wanted).sign(), 0) << round;
    const auto of_few = farthest_of_few(b, a, p);
    ASSERT_TRUE(of_few);
    ASSERT_EQ((of_few->value - wanted).sign(), 0) << round;
  }
}

TEST(FarCorners, TheOnlyFarthestTellsHowFarAllProtrude) {
  std::mt19937 random(6);
  const Body box = space::box_body({{{{-3, -2, -5}, {4, 3, 6}}}});
  int told = 0;
  for (int round = 0; round < 100; ++round) {
    Body b;
    for (const Point& v : random_points(random, 20, 12)) b.parts.push_back({std::nullopt, v, Real()});
    const RealVector p = place(round % 9 - 4, 2 * round - 100, round % 5, 3);
    const auto only = only_farthest(corners_of(b), box.parts[0], p);
    if (!only) continue;
    ++told;
    Body alone;
    alone.parts.push_back(*only);
    const Answer all = protrusion_of_convex(b, box.parts[0], p), one = protrusion_of_convex(alone, box.parts[0], p);
    ASSERT_EQ((all.value - one.value).sign(), 0) << round;
  }
  EXPECT_GT(told, 60);
}

TEST(FarCorners, NoneIsTheOnlyOneWhereTwoAreOrAllLieWithin) {
  const Body box = space::box_body({{{{-3, -3, -3}, {3, 3, 3}}}});
  const std::vector<Point> two{{7, 1, 0}, {7, 2, 0}, {1, 1, 1}}, within{{1, 1, 1}, {0, 0, 0}},
      one{{7, 1, 0}, {6, 0, 0}};
  const auto only = [&](const std::vector<Point>& points) {
    return only_farthest({{points, Real()}}, box.parts[0], {});
  };
  EXPECT_FALSE(only(two));
  EXPECT_FALSE(only(within));
  ASSERT_TRUE(only(one));
  EXPECT_EQ(only(one)->center, (Point{7, 1, 0}));
}

TEST(FarCorners, AnOutlineThatIsAskedOftenMakesItsHull) {
  space::Body body = space::box_body({{{{0, 0, 0}, {4, 4, 4}}}, {{{4, 0, 0}, {8, 4, 4}}}});
  auto set = std::make_shared<space::SurfaceSet>();
  ASSERT_TRUE(set->add(body, 1));
  const Outline outline = Outline::of(set, 1);
  EXPECT_EQ(outline.corners().size(), 2u);  // one list for each surface
  for (int k = 0; k < 100; ++k) outline.corners();
  const auto often = outline.corners();
  ASSERT_EQ(often.size(), 1u);
  EXPECT_EQ(often[0].points.size(), 8u);
}

}  // namespace distance_far_corners
}  // namespace findspace::distance
