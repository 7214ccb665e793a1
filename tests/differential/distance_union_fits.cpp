// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a shape is from fitting into a union of round parts, and the farthest place where it fits, against formulas
// and against the definition: the nearest place belongs, and walks that keep to those that do come no nearer.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "distance/rays/ray_signs.h"
#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_union_fits {

using exact::Real;
using space::Body;
using space::Point;
using space::Vector;

Body capsule(const Point& from, const Point& to, const Real& radius) {
  Body b;
  b.parts.push_back(space::part_of(std::vector<Point>{from, to}, radius));
  return b;
}

Body ball(const Point& center, const Real& radius) {
  Body b;
  b.parts.push_back({std::nullopt, center, radius});
  return b;
}

Body both(Body a, const Body& b) {
  a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
  return a;
}

PairDistances pair_of(const Body& b, const Body& a) { return solid_pair(space::shared(b), space::shared(a)); }

/// Two balls of radius 50 that meet in a circle of radius 40.
Body two_balls() { return both(ball({}, Real(50)), ball({60, 0, 0}, Real(50))); }

/// The nearest place is where the ball touches the circle in which the two balls meet.
TEST(UnionFits, BallInTheWaistOfTwoBalls) {
  const PairDistances pair = pair_of(ball({}, Real(30)), two_balls());
  const auto v = pair.value(Which::kEta1, space::place(30, 20, 0));
  ASSERT_TRUE(v);
  EXPECT_NEAR(v->value.to_double(), 10, 1e-8);
  ASSERT_TRUE(v->nearest);
  EXPECT_NEAR((*v->nearest)[1].to_double(), 10, 1e-6);
  EXPECT_LT(std::fabs(v->value.to_double() - 10), v->error);
  EXPECT_FALSE(pair_of(ball({}, Real(51)), two_balls()).value(Which::kEta1, space::place(30, 20, 0)));
}

/// In one ball alone, which no place of both betters: an exact number.
TEST(UnionFits, InOnePart) {
  const PairDistances pair = pair_of(ball({}, Real(20)), two_balls());
  const auto v = pair.value(Which::kEta1, space::place(-60, 80, 0));
  ASSERT_TRUE(v);
  EXPECT_TRUE(v->proven);
  EXPECT_EQ(v->value, Real(70));
  const auto far = pair.value(Which::kEta2, space::place(-60, 80, 0));
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->value.to_double(), std::hypot(120, 80) + 30, 1e-7);
}

/// A ball as round as a bent tube has zero clearance in it: it fits along the two segments only.
TEST(UnionFits, ZeroClearanceInATube) {
  const Body tube = both(capsule({}, {80, 0, 0}, Real(30)), capsule({80, 0, 0}, {80, 70, 0}, Real(30)));
  const PairDistances pair = pair_of(ball({}, Real(30)), tube);
  const auto v = pair.value(Which::kEta1, space::place(90, 90, 30));
  ASSERT_TRUE(v);
  EXPECT_EQ(v->value, sqrt(Real(100 + 400 + 900)));
  EXPECT_FALSE(pair_of(ball({}, Real(31)), tube).value(Which::kEta1, space::place(90, 90, 30)));
}

/// Whether the box [-40, 40] x [-12, 12] x [-20, 20] lies in both balls together: its edges along x are farthest from
/// their axis, and protrude most at their ends and in the middle plane.
bool box_fits(const Vector& x) {
  for (const double y : {x.y - 12, x.y + 12}) {
    for (const double z : {x.z - 20, x.z + 20}) {
      for (const double at : {x.x - 40, x.x + 40, std::clamp(30.0, x.x - 40, x.x + 40)}) {
        const Vector corner{at, y, z};
        if (space::length(corner) > 50 && space::length(corner - Vector{60, 0, 0}) > 50) return false;
      }
    }
  }
  return true;
}

TEST(UnionFits, BoxInTwoBalls) {
  const PairDistances pair = pair_of(space::box_body({{{{-40, -12, -20}, {40, 12, 20}}}}), two_balls());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int n = 0; n < 8; ++n) {
    const Vector p{30 + std::round(40 * some(random)), std::round(50 * some(random)), std::round(40 * some(random))};
    if (box_fits(p)) continue;
    const auto v = pair.value(Which::kEta1, {Real::from_double(p.x), Real::from_double(p.y), Real::from_double(p.z)});
    ASSERT_TRUE(v);
    ASSERT_TRUE(v->nearest);
    const double d = v->value.to_double();
    const Vector q = space::rounded(*v->nearest);
    EXPECT_NEAR(space::length(q - p), d, 1e-7);
    EXPECT_TRUE(box_fits(q));
    double best = d;
    Vector at = q;
    for (double step = 20; step > 1e-3; step *= 0.8) {
      for (int k = 0; k < 40; ++k) {
        const Vector next = space::plus(at, {step * some(random), step * some(random), step * some(random)});
        if (space::length(next - p) < best && box_fits(next)) {
          at = next;
          best = space::length(next - p);
        }
      }
    }
    EXPECT_GT(best, d - 1e-6) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

/// Where a line passes the level, the value is that, and between the ends of a stretch it has the stretch's sign.
TEST(UnionFits, OnLines) {
  const Body box = space::box_body({{{{-10, -4, -4}, {10, 4, 4}}}});
  const PairDistances pair = pair_of(box, two_balls());
  const space::RayGrid grid{2, 1, 20, 50, 1, 1, 1, 1};
  for (const auto& [which, level] : {std::pair{Which::kEta1, 12}, {Which::kEta2, 115}}) {
    const auto value = [&, which = which](const Real& z) {
      return pair.value(which, {Real(20), Real(50), z})->value.to_double();
    };
    const space::RayRow row = ray_sign_map(which, Real(level), box, two_balls(), grid)->row(0);
    ASSERT_EQ(row.events.size(), 4U);  // both ends of {= level}, twice
    for (const space::RayEvent& e : row.events) EXPECT_NEAR(value(e.at.to_real()), level, 1e-5);
    EXPECT_EQ(row.events[1].after, -1);
    EXPECT_LT(value((row.events[1].at.to_real() + row.events[2].at.to_real()) / Real(2)), level);
  }
}

/// How deep the box lies in the rounded L is not found where it lies along a wall of its parts; its sign above 0 is.
TEST(UnionFits, OnALineThroughTheInside) {
  Body room = space::box_body({{{{0, 0, 0}, {100, 40, 40}}}, {{{0, 0, 0}, {40, 100, 40}}}});
  for (space::BodyPart& part : room.parts) part.radius = Real(20);
  const Body box = space::box_body({{{{-10, -10, -10}, {20, 10, 10}}}});
  const space::RayGrid grid{0, 1, 50, 10, 1, 1, 1, 1};  // y = 50, z = 10
  const space::RayRow row = ray_sign_map(Which::kEta1, Real(5), box, room, grid)->row(0);
  ASSERT_EQ(row.events.size(), 4U);
  const PairDistances pair = pair_of(box, room);
  for (const space::RayEvent& e : row.events)
    EXPECT_NEAR(pair.value(Which::kEta1, {e.at.to_real(), Real(50), Real(10)})->value.to_double(), 5, 1e-5);
}

}  // namespace distance_union_fits
}  // namespace findspace::distance
