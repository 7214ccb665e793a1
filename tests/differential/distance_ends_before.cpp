// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values of searches that end before they are known, which were refused: against closed forms, which lie between the
// ends, and against samples. And the least values along a direction in unions of round parts and in solids that round
// ones are cut out of.
#include <gtest/gtest.h>

#include "distance/csg/csg_pair.h"
#include "distance/rays/ray_directional_least.h"
#include "unit/cut_cases.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_ends_before {

using exact::Real;
using space::Body;
using space::Point;
using space::RealVector;
using Kind = plane::Shape::Kind;

Body ball_of(const Point& center, std::int64_t radius) {
  Body b;
  b.parts.push_back({std::nullopt, center, Real(radius)});
  return b;
}

std::shared_ptr<const CsgSide> cut_side(const Body& b, const plane::ShapePtr& a) {
  return std::make_shared<const CsgSide>(space::shared(b),
                                         std::make_shared<const space::CsgSolid>(space::csg_solid(*a)));
}

PairDistances cut_pair(const Body& b, const plane::ShapePtr& a) { return csg_pair(cut_side(b, a), false); }

plane::ShapePtr shell(std::int64_t outer, std::int64_t inner) {
  return space::node(Kind::kDifference, {space::ball({}, outer), space::ball({}, inner)});
}

void expect_between(const Answer& v, double expected, double wide) {
  const Enclosure ends = v.bounds();
  ASSERT_TRUE(ends.lower && ends.upper);
  EXPECT_LE(ends.lower->to_double(), expected + 1e-9);
  EXPECT_GE(ends.upper->to_double(), expected - 1e-9);
  EXPECT_LE(ends.width(), wide);
}

/// It is as large as the hollow, so the only free place nearby is the centre.
TEST(EndsBefore, BallNearTheHollowOfAShell) {
  const PairDistances pair = cut_pair(ball_of({}, 60), shell(120, 60));
  for (const Point& p : {Point{9, 6, 3}, Point{0, 0, 20}}) {
    const auto v = pair.value(Which::kGamma1, space::place(p.x, p.y, p.z));
    ASSERT_TRUE(v);
    expect_between(*v, -std::sqrt(double(p.x * p.x + p.y * p.y + p.z * p.z)), 0.1);
  }
}

/// No position nearer than the lower end is free, and the one that is named is.
TEST(EndsBefore, DepthsInAUnionWithABowl) {
  const auto bowl = space::node(Kind::kDifference, {box({0, 0, 0}, {60, 60, 40}), space::ball({30, 30, 40}, 20)});
  const auto all = space::node(Kind::kUnion, {bowl, box({50, 0, 0}, {80, 20, 20})});
  std::mt19937 random(3);
  std::vector<Vector> solid;
  while (solid.size() < 60000) {
    const Vector x = any(random, 90);
    const bool in_bowl = to_box(x, {0, 0, 0}, {60, 60, 40}) < 0 && to_ball(x, {30, 30, 40}, 20) > 0;
    if (in_bowl || to_box(x, {50, 0, 0}, {80, 20, 20}) < 0) solid.push_back(x);
  }
  struct Moving {
    Body body;
    std::function<double(const Vector&)> level;
  };
  const std::vector<Moving> moving{{space::box_body({{{{0, 0, 0}, {40, 40, 40}}}}),
                                    [](const Vector& x) {
                                      return to_box(x, {0, 0, 0}, {40, 40, 40});
                                    }},
                                   {ball_of({}, 20), [](const Vector& x) { return to_ball(x, {}, 20); }}};
  const Vector p{25, 30, 10};
  for (const Moving& b : moving) {
    const auto v = cut_pair(b.body, all).value(Which::kGamma1, space::real(p));
    ASSERT_TRUE(v && v->nearest);
    const auto free = [&](const Vector& q) {
      return std::none_of(solid.begin(), solid.end(), [&](const Vector& x) { return b.level(x - q) < -0.5; });
    };
    const double least = -v->bounds().upper->to_double();
    EXPECT_GT(least, 0);
    EXPECT_LE(v->bounds().width(), 2);
    EXPECT_TRUE(free(space::rounded(*v->nearest)));
    for (int k = 0; k < 60; ++k) {
      const Vector by = any(random, 1);
      EXPECT_FALSE(free(space::plus(p, space::scaled((least - 1.5) / space::length(by), by))));
    }
  }
}

/// The largest ball in a lens touches both of its faces.
TEST(EndsBefore, ZeroClearanceInALens) {
  const auto lens = space::node(Kind::kIntersection, {space::ball({}, 40), space::ball({40, 0, 0}, 40)});
  const PairDistances pair = cut_pair(ball_of({}, 20), lens);
  const RealVector p = space::place(3, 2, 1);
  const auto near = pair.value(Which::kEta1, p), far = pair.value(Which::kEta2, p);
  ASSERT_TRUE(near && far);
  expect_between(*near, std::sqrt(17.0 * 17 + 5), 1e-3);
  EXPECT_LE(far->bounds().lower->to_double(), std::sqrt(17.0 * 17 + 5) + 1e-9);
}

/// From where the rounded edges leave a groove.
TEST(EndsBefore, AcrossRoundedPartsThatLieFlush) {
  Body a = space::box_body({{{{0, 0, 0}, {40, 40, 40}}}, {{{60, 0, 0}, {100, 40, 40}}}});
  for (space::BodyPart& part : a.parts) part.radius = Real(10);
  const PairDistances pair = solid_pair(space::shared(ball_of({}, 10)), space::shared(a));
  const auto v = pair.value(Which::kEta1, space::place(50, 20, 20));
  ASSERT_TRUE(v);
  expect_between(*v, -10, 30);
}

/// All of them lie in the ball where it lies in as many others.
TEST(EndsBefore, FarthestFitOfManyCornersInABall) {
  std::vector<Point> corners;
  for (int k = 0; k < 48; ++k) {
    const double angle = k * 0.13089969389957, high = k % 2 == 0 ? 12 : -12;
    corners.push_back({std::lround(30 * std::cos(angle)), std::lround(30 * std::sin(angle)), std::lround(high)});
  }
  Body b;
  b.parts.push_back(space::part_of(corners, Real()));
  ASSERT_GT(b.parts[0].vertices().size(), 40U);
  const PairDistances pair = solid_pair(space::shared(b), space::shared(ball_of({}, 50)));
  const Vector p{5, -70, 20};
  const auto v = pair.value(Which::kEta2, space::real(p));
  ASSERT_TRUE(v && v->farthest);
  const auto fits = [&](const Vector& q) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Point& c) { return space::length(space::plus(exact::approx(c), q)) <= 50 + 1e-9; });
  };
  EXPECT_TRUE(fits(space::rounded(*v->farthest)));
  std::mt19937 random(1);
  double most = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vector q = any(random, 25);
    if (fits(q)) most = std::max(most, space::length(q - p));
  }
  EXPECT_LE(most, v->bounds().upper->to_double() + 1e-9);
  EXPECT_GT(most, v->bounds().lower->to_double() - 2);
}

RealVector direction(std::int64_t x, std::int64_t y, std::int64_t z) { return {Real(x), Real(y), Real(z)}; }

/// Through the waist of two balls.
TEST(EndsBefore, LeastFitAlongADirectionInTwoBalls) {
  Body a = ball_of({}, 50);
  a.parts.push_back({std::nullopt, {60, 0, 0}, Real(50)});
  const auto least = [&](const RealVector& way, bool both, std::int64_t radius) {
    return ray_directional_least(Which::kEta1, way, both, ball_of({}, radius), a).or_throw();
  };
  const auto through = least(direction(3, 0, 0), true, 30), across = least(direction(0, 1, 0), false, 30);
  ASSERT_TRUE(through && across);
  expect_between(*through, -50, 1);
  EXPECT_NEAR(through->at[0].to_double(), 30, 1);
  expect_between(*across, -40, 2);
  EXPECT_FALSE(is_taken(*across));
  EXPECT_FALSE(least(direction(1, 0, 0), true, 51));
}

/// Beside the hollow of a shell, or around it.
TEST(EndsBefore, LeastAlongADirectionInAShell) {
  const auto side = cut_side(ball_of({}, 10), shell(100, 60));
  for (const RealVector& way : {direction(1, 0, 0), direction(1, 2, -2)}) {
    const auto fit = csg_directional_least(Which::kEta1, side, false, way, true).or_throw();
    const auto gap = csg_directional_least(Which::kGamma1, side, false, way, true).or_throw();
    ASSERT_TRUE(fit && gap);
    expect_between(*fit, -std::sqrt(90.0 * 90 - 70 * 70), 0.1);
    expect_between(*gap, -std::sqrt(110.0 * 110 - 50 * 50), 20);
  }
}

/// Below the pocket of a bowl what holds it says all.
TEST(EndsBefore, LeastAlongADirectionInABowl) {
  const auto bowl = space::node(Kind::kDifference, {box({0, 0, 0}, {60, 60, 40}), space::ball({30, 30, 40}, 20)});
  const auto side = cut_side(space::box_body({{{{0, 0, 0}, {10, 10, 10}}}}), bowl);
  const auto fit = csg_directional_least(Which::kEta1, side, false, direction(1, 0, 0), true).or_throw();
  const auto gap = csg_directional_least(Which::kGamma1, side, false, direction(1, 0, 0), true).or_throw();
  ASSERT_TRUE(fit && gap);
  expect_between(*fit, -25, 0.1);
  expect_between(*gap, -35, 1e-6);
  const auto back = csg_directional_least(Which::kDelta1, side, true, direction(1, 0, 0), true).or_throw();
  ASSERT_TRUE(back);
  EXPECT_EQ(back->value, fit->value);
  const auto room = cut_side(space::box_body({{{{0, 0, 0}, {100, 70, 50}}}}), bowl);
  const auto moved = csg_directional_least(Which::kEta1, room, true, direction(0, 1, 0), false).or_throw();
  ASSERT_TRUE(moved);
  expect_between(*moved, -10, 1e-6);
}

/// A + p fits into a round part where all of it does.
struct RoundRoom {
  Body body;
  std::function<double(const Vector&)> level;
};

std::vector<RoundRoom> rooms() {
  Body rounded = space::box_body({{{{-10, -10, -10}, {30, 20, 10}}}});
  rounded.parts[0].radius = Real(30);
  Body both = rounded;
  both.parts.push_back({std::nullopt, {60, 0, 0}, Real(45)});
  const auto in_box = [](const Vector& x) { return to_box(x, {-10, -10, -10}, {30, 20, 10}) - 30; };
  return {{ball_of({5, 0, 0}, 50),
           [](const Vector& x) {
             return to_ball(x, {5, 0, 0}, 50);
           }},
          {rounded, in_box},
          {both, [=](const Vector& x) {
             return std::min(in_box(x), to_ball(x, {60, 0, 0}, 45));
           }}};
}

/// By samples of a lens and a bowl: how far they are from fitting, or how deep they lie in the room, and how far off
/// they fit.
TEST(EndsBefore, CutShapesInRoundRooms) {
  const auto lens = space::node(Kind::kIntersection, {space::ball({}, 25), space::ball({20, 0, 0}, 25)});
  const auto bowl = space::node(Kind::kDifference, {box({0, 0, 0}, {20, 20, 16}), space::ball({10, 10, 16}, 8)});
  const auto in_lens = [](const Vector& x) { return std::max(to_ball(x, {}, 25), to_ball(x, {20, 0, 0}, 25)); };
  const auto in_bowl = [](const Vector& x) {
    return std::max(to_box(x, {0, 0, 0}, {20, 20, 16}), -to_ball(x, {10, 10, 16}, 8));
  };
  std::mt19937 random(9);
  std::vector<Vector> of_lens, of_bowl;  // all that can be farthest from a room, about
  for (int k = 0; k < 3000; ++k) {
    const Vector by = any(random, 1), out = space::scaled(25 / space::length(by), by);
    for (const Vector& x : {out, space::plus(out, {20, 0, 0})}) {
      if (in_lens(x) < 1e-9) of_lens.push_back(x);
    }
    const double rim = std::sqrt(525.0), angle = 6.283185 * k / 3000;
    of_lens.push_back({10, rim * std::cos(angle), rim * std::sin(angle)});
    const Vector x = any(random, 20);
    if (in_bowl(x) < 0) of_bowl.push_back(x);
  }
  for (int k = 0; k < 8; ++k) of_bowl.push_back({k & 1 ? 20.0 : 0.0, k & 2 ? 20.0 : 0.0, k & 4 ? 16.0 : 0.0});
  int told = 0;
  struct Solid {
    plane::ShapePtr shape;
    std::vector<Vector> points;
  };
  for (const Solid& solid : {Solid{lens, of_lens}, {bowl, of_bowl}}) {
    for (const RoundRoom& room : rooms()) {
      const auto side = cut_side(room.body, solid.shape);
      const PairDistances pair = csg_pair(side, true);
      const auto out = [&](const Vector& q) {
        double most = -exact::kInfinity;
        for (const Vector& x : solid.points) most = std::max(most, room.level(space::plus(x, q)));
        return most;
      };
      for (const Vector& p : {Vector{70, 40, -35}, Vector{-8, -6, -5}, Vector{12, 40, 3}}) {
        const auto near = pair.value(Which::kEta1, space::real(p)), far = pair.value(Which::kEta2, space::real(p));
        ASSERT_TRUE(near && far);
        const Enclosure ends = near->bounds(), farthest = far->bounds();
        if (near->nearest) {
          EXPECT_LE(out(space::rounded(*near->nearest)), 1e-6);
        }
        if (far->farthest) {
          EXPECT_LE(out(space::rounded(*far->farthest)), 1e-6);
        }
        told += ends.upper && ends.width() < 1e-3;
        for (int k = 0; k < 200; ++k) {
          const Vector by = any(random, 1);
          const Vector next = space::plus(p, space::scaled((ends.lower->to_double() - 1) / space::length(by), by));
          if (ends.lower->to_double() > 1) {
            EXPECT_GT(out(next), -0.5);
          }
          const Vector q = any(random, 60);
          if (farthest.upper && out(q) < -1) {
            EXPECT_LE(space::length(q - p), farthest.upper->to_double());
          }
        }
        if (ends.upper && ends.upper->sign() < 0) {
          EXPECT_LE(out(p), ends.upper->to_double() + 1e-6);
        }
      }
    }
  }
  EXPECT_GT(told, 8);
}

}  // namespace distance_ends_before
}  // namespace findspace::distance
