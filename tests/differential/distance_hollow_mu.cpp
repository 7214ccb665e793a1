// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a shape protrudes from a complement: the depth of its deepest point in what the complement leaves, against
// formulas for that depth at samples of the shape, and its signs on lines against the values.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "distance/rays/ray_signs.h"
#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_hollow_mu {

using exact::Real;
using space::Body;
using space::Point;
using space::Vector;

/// The depth of a point in what the complement leaves, at most 0 outside.
using Depth = std::function<double(const Vector&)>;

Body outside(Body a) {
  a.outside = true;
  return a;
}

Body part(std::vector<Point> corners, const Real& radius) {
  Body b;
  b.parts.push_back(space::part_of(corners, radius));
  return b;
}

Body rounded(Body b, const Real& radius) {
  b.parts[0].radius = radius;
  return b;
}

double box_depth(const Vector& x, const Vector& low, const Vector& high) {
  return std::min({x.x - low.x, x.y - low.y, x.z - low.z, high.x - x.x, high.y - x.y, high.z - x.z});
}

/// Of [0, 8] x [0, 4] x [0, 4] and [0, 4] x [0, 8] x [0, 4].
double l_depth(const Vector& x) {
  const double walls = std::min({x.x, x.y, x.z, 8 - x.x, 8 - x.y, 4 - x.z});
  return std::min(walls, std::hypot(std::min(0.0, x.x - 4), std::min(0.0, x.y - 4)));
}

double rounded_depth(const Vector& x) {  // [-2, 2]^3 grown by 1
  const double in = box_depth(x, {-2, -2, -2}, {2, 2, 2});
  if (in >= 0) return in + 1;
  const auto off = [](double c) { return std::max(0.0, std::fabs(c) - 2); };
  return 1 - std::hypot(off(x.x), off(x.y), off(x.z));
}

double capsule_depth(const Vector& x) {  // [-3, 3] on the x-axis, of radius 2
  return 2 - std::hypot(std::max(0.0, std::fabs(x.x) - 3), x.y, x.z);
}

/// In two balls of radius 5 about the origin and (7, 0, 0): to the spheres, and to the circle in which they meet.
double pair_depth(const Vector& x) {
  const Vector centers[] = {{0, 0, 0}, {7, 0, 0}};
  double least = std::hypot(std::hypot(x.y, x.z) - std::sqrt(12.75), x.x - 3.5);
  bool inside = false;
  for (int k = 0; k < 2; ++k) {
    const Vector way = x - centers[k];
    const double far = space::length(way);
    inside = inside || far < 5;
    const Vector on = space::plus(centers[k], space::scaled(5 / far, way));
    if (far < 5 && space::length(on - centers[1 - k]) >= 5) least = std::min(least, 5 - far);
  }
  return inside ? least : 0;
}

/// Points of the box [-1, 1] x [-1, 2] x [0, 1], grown by the radius.
Vector sample(std::mt19937& random, double radius) {
  const auto pick = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  Vector v{pick(-1, 1), pick(-1, 2), pick(0, 1)};
  for (;;) {
    const Vector d{pick(-1, 1), pick(-1, 1), pick(-1, 1)};
    if (space::length(d) <= 1) return space::plus(v, space::scaled(radius, d));
  }
}

void expect_depths(const Body& b, double radius, const Body& a, const Depth& depth, const Vector& middle,
                   int count = 60) {
  const PairDistances pair = solid_pair(space::shared(b), space::shared(outside(a)));
  std::mt19937 random(5);
  int positive = 0;
  for (int n = 0; n < count; ++n) {
    const Vector p = space::plus(middle, {std::round(random() % 1000 / 60.0) - 8 + 1.0 / 64,
                                          std::round(random() % 1000 / 60.0) - 8, random() % 64 / 8.0 - 4});
    const auto v = pair.value(Which::kMu, {Real::from_double(p.x), Real::from_double(p.y), Real::from_double(p.z)});
    ASSERT_TRUE(v);
    double most = -1e9;
    for (int k = 0; k < 20000; ++k) most = std::max(most, depth(space::plus(p, sample(random, radius))));
    const double found = v->value.to_double();
    if (found <= 0) {
      EXPECT_LE(most, 1e-9);
      continue;
    }
    ++positive;
    EXPECT_GE(found, most - 1e-9) << p.x << ' ' << p.y << ' ' << p.z;
    EXPECT_LE(found, std::max(most, 0.0) + 0.35) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_GT(positive, count / 12);
}

TEST(HollowMu, ValuesAgainstSamples) {
  const Body box = space::box_body({{{{-1, -1, 0}, {1, 2, 1}}}}), round = rounded(box, Real(1));
  const Body hollow_box = space::box_body({{{{-4, -3, -5}, {4, 3, 5}}}});
  const Depth in_box = [](const Vector& x) { return box_depth(x, {-4, -3, -5}, {4, 3, 5}); };
  expect_depths(box, 0, hollow_box, in_box, {});
  expect_depths(round, 1, hollow_box, in_box, {});
  const Body ell = space::box_body({{{{0, 0, 0}, {8, 4, 4}}}, {{{0, 0, 0}, {4, 8, 4}}}});
  expect_depths(box, 0, ell, l_depth, {3, 3, 2});
  expect_depths(round, 1, ell, l_depth, {3, 3, 2});
  Body ball;
  ball.parts.push_back({std::nullopt, {0, 0, 0}, Real(4)});
  expect_depths(box, 0, ball, [](const Vector& x) { return 4 - space::length(x); }, {});
  expect_depths(round, 1, rounded(space::box_body({{{{-2, -2, -2}, {2, 2, 2}}}}), Real(1)), rounded_depth, {});
  expect_depths(box, 0, part({{-3, 0, 0}, {3, 0, 0}}, Real(2)), capsule_depth, {});
}

/// A ball in a ball: known in closed form.
TEST(HollowMu, BallInBall) {
  Body ball, hole;
  ball.parts.push_back({std::nullopt, {1, 0, 0}, Real(1)});
  hole.parts.push_back({std::nullopt, {0, 0, 0}, Real(5)});
  const PairDistances pair = solid_pair(space::shared(ball), space::shared(outside(hole)));
  EXPECT_EQ(pair.value(Which::kMu, space::place(2, 4, 0))->value.text(), Real(1).text());  // the middle is 5 away
  EXPECT_EQ(pair.value(Which::kMu, space::place(-1, 0, 0))->value.text(), Real(5).text());
  EXPECT_EQ(pair.value(Which::kMu, space::place(5, 0, 0))->value.text(), Real(0).text());
  EXPECT_EQ(pair.value(Which::kMu, space::place(9, 0, 0))->value.text(), Real(-4).text());
  EXPECT_EQ(pair.value(Which::kH, space::place(9, 0, 0))->value.text(), Real(0).text());
  hole.parts.push_back({std::nullopt, {7, 0, 0}, Real(5)});
  const PairDistances two = solid_pair(space::shared(ball), space::shared(outside(hole)));
  EXPECT_EQ(two.value(Which::kMu, space::place(20, 0, 0))->value.text(), Real(-8).text());
  hole.outside = false;
  expect_depths(space::box_body({{{{-1, -1, 0}, {1, 2, 1}}}}), 0, hole, pair_depth, {3, 0, 0}, 12);
}

TEST(HollowMu, SignsOnLines) {
  const Body b = space::box_body({{{{-2, -2, -1}, {2, 3, 2}}}});
  const Body a = outside(space::box_body({{{{0, 0, 0}, {8, 4, 4}}}, {{{0, 0, 0}, {4, 8, 4}}}}));
  const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
  const space::RayGrid grid{2, 2, -7, -9, 7, 5, 4, 5};
  int negative = 0, positive = 0;
  for (const Which which : {Which::kMu, Which::kH}) {
    for (const Real& level : {Real(1), Real(0), Real(-1)}) {
      const auto rays = ray_sign_map(which, level, b, a, grid);
      for (int j = 0; j < grid.nv; ++j) {
        const space::RayRow row = rays->row(j);
        for (int i = 0; i < grid.nu; ++i) {
          for (int z = -20; z <= 40; z += 3) {
            const auto v =
                pair.value(which, {Real::ratio(grid.u_at(i), 2), Real::ratio(grid.v_at(j), 2), Real::ratio(z, 4)});
            const double gap = (v->value - level).to_double();
            const bool sure = std::fabs(gap) > 1e-6;
            const int sign = space::sign_at(row, i, Real::ratio(z, 2));
            EXPECT_TRUE(!sure || sign == (gap < 0 ? -1 : 1)) << i << ' ' << j << ' ' << z << ' ' << level.text();
            negative += sign < 0;
            positive += sign > 0;
          }
        }
      }
    }
  }
  EXPECT_GT(negative, 50);
  EXPECT_GT(positive, 50);
}

}  // namespace distance_hollow_mu
}  // namespace findspace::distance
