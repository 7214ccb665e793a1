// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep a body is in a solid that balls are cut out of or that is cut off by them: at the place that is said to be
// the nearest free one no sampled place of the solid is in the body, and at no position that is nearer they are apart.
#include <gtest/gtest.h>

#include "distance/csg/csg_pair.h"
#include "distance/search/meet_slack.h"
#include "unit/cut_cases.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_cut_depth {

using exact::Real;
using space::Body;
using space::RealVector;
using Kind = plane::Shape::Kind;

plane::ShapePtr rounded(const plane::ShapePtr& shape) {
  plane::Shape out;
  out.kind = Kind::kOffset;
  out.amount = Real(1);
  out.children = {shape};
  return std::make_shared<const plane::Shape>(std::move(out));
}

struct Moving {
  Body body;
  std::function<double(const Vector&)> level;
};

std::vector<Moving> moving() {
  return {{space::body(*box({-3, -3, -3}, {3, 3, 3})),
           [](const Vector& x) {
             return to_box(x, {-3, -3, -3}, {3, 3, 3});
           }},
          {space::body(*space::ball({1, 0, 0}, 4)),
           [](const Vector& x) {
             return to_ball(x, {1, 0, 0}, 4);
           }},
          {space::body(*rounded(box({-3, -2, -1}, {2, 2, 2}))), [](const Vector& x) {
             return to_box(x, {-3, -2, -1}, {2, 2, 2}) - 1;
           }}};
}

PairDistances pair_of(const plane::Shape& fixed, const Body& body) {
  return csg_pair(std::make_shared<const CsgSide>(space::shared(body),
                                                  std::make_shared<const space::CsgSolid>(space::csg_solid(fixed))),
                  false);
}

TEST(CsgDepth, IsThatOfSamples) {
  std::mt19937 random(5);
  int deep = 0;
  for (const Case& c : cases()) {
    std::vector<Vector> solid;
    while (solid.size() < 40000) {
      const Vector x = any(random, 30);
      if (c.level(x) < 0) solid.push_back(x);
    }
    for (const Moving& b : moving()) {
      const PairDistances pair = pair_of(*c.shape, b.body);
      for (int k = 0; k < 3; ++k) {
        const Vector at = solid[random() % solid.size()];
        const RealVector p{Real::from_double(at.x), Real::from_double(at.y), Real::from_double(at.z)};
        const Answer v = *pair.value(Which::kGamma1, p);
        const double depth = -v.value.to_double();
        if (!(depth > 0) || !v.nearest) continue;
        ++deep;
        const Vector q = space::rounded(*v.nearest);
        EXPECT_NEAR(space::length(q - at), depth, 1e-10) << c.name;
        for (const Vector& x : solid) EXPECT_GT(b.level(x - q), -1e-9) << c.name;
        for (int n = 0; n < 20; ++n) {
          Vector way = any(random, 1);
          way = space::scaled(0.98 * depth / space::length(way), way);
          const Vector near = space::plus(at, way);
          const RealVector r{Real::from_double(near.x), Real::from_double(near.y), Real::from_double(near.z)};
          EXPECT_EQ(pair.value(Which::kD1, r)->value, Real()) << c.name;
        }
      }
    }
  }
  EXPECT_GT(deep, 25);
}

double depth(const plane::Shape& fixed, const Body& body, const RealVector& p) {
  return -pair_of(fixed, body).value(Which::kGamma1, p)->value.to_double();
}

TEST(CsgDepth, IsTheOneOfFormulas) {
  using space::ball, space::node, space::place;
  // A ball in the wall of a shell: to the hollow, or out.
  const auto shell = node(Kind::kDifference, {ball({0, 0, 0}, 24), ball({0, 0, 0}, 18)});
  const Body small = space::body(*ball({0, 0, 0}, 4));
  EXPECT_NEAR(depth(*shell, small, place(20, 0, 0)), 6, 1e-12);
  EXPECT_NEAR(depth(*shell, small, place(0, 22, 0)), 6, 1e-12);
  // Beside the axis of a lens a ball leaves by its rim, a circle of radius 12 about z = 0: (16, 0, 0) is as near.
  const auto lens = node(Kind::kIntersection, {ball({0, 0, -9}, 15), ball({0, 0, 9}, 15)});
  EXPECT_NEAR(depth(*lens, small, place(13, 0, 0)), 3, 1e-11);
  // A cube that touches the rim with an edge.
  EXPECT_NEAR(depth(*lens, space::body(*box({-3, -3, -3}, {3, 3, 3})), place(14, 0, 0)), 1, 1e-11);
  // Of two pockets the cube leaves for the nearer one, with its corners on the sphere.
  const auto pockets =
      node(Kind::kDifference, {box({-20, -20, -20}, {20, 20, 20}), ball({-20, -20, 0}, 17), ball({20, 20, 0}, 17)});
  const Body cube = space::body(*box({-3, -3, -3}, {3, 3, 3}));
  const Answer v = *pair_of(*pockets, cube).value(Which::kGamma1, place(0, 0, 0));
  EXPECT_TRUE(v.proven);
  EXPECT_TRUE(pair_of(*pockets, cube).value(Which::kGamma1, place(0, 0, 3))->proven);
  // (20 - x + 3)^2 twice and 9 make 289.
  EXPECT_NEAR(-v.value.to_double(), std::sqrt(2.0) * (23 - std::sqrt(140.0)), 1e-10);
}

/// Up into a pocket, by the lower corners of the core, whichever of the two is rounded.
TEST(CsgDepth, IsThatOfRoundedPolyhedra) {
  using space::ball, space::node, space::place;
  const auto bowl = node(Kind::kDifference, {box({-20, -20, -20}, {20, 20, 20}), ball({0, 0, 20}, 15)});
  const auto cube = box({-2, -2, -2}, {2, 2, 2});
  EXPECT_NEAR(depth(*bowl, space::body(*rounded(cube)), place(0, 0, 3)), 17 - std::sqrt(188.0) + 2, 1e-10);
  // A dome with a rounded rim is as deep above as its ball.
  const auto dome = node(Kind::kIntersection, {ball({0, 0, 0}, 20), rounded(box({-30, -30, 1}, {30, 30, 30}))});
  EXPECT_NEAR(depth(*dome, space::body(*ball({0, 0, 0}, 4)), place(0, 0, 15)), 9, 1e-10);
  EXPECT_NEAR(depth(*dome, space::body(*rounded(cube)), place(1, 1, 4)), 7, 1e-10);
}

TEST(CsgDepth, HasLines) {
  // A ball of radius 4 in a dome of height 20: deeper than 3 between -1 and 21.
  const auto dome = space::node(Kind::kIntersection, {space::ball({0, 0, 0}, 20), box({-30, -30, 0}, {30, 30, 30})});
  const auto pair = std::make_shared<const CsgSide>(space::shared(space::body(*space::ball({0, 0, 0}, 4))),
                                                    std::make_shared<const space::CsgSolid>(space::csg_solid(*dome)));
  const space::RayGrid grid{2, 1, 0, 0, 1, 1, 1, 1};
  const space::RayRow deep = cut_map(Which::kGamma1, Real(-3), pair, 1, grid)->row(0);
  const space::RayRow out = cut_map(Which::kPenetration, Real(3), pair, 1, grid)->row(0);
  for (const auto& [z, sign] : {std::pair{-2, 1}, {0, -1}, {20, -1}, {22, 1}, {40, 1}}) {
    EXPECT_EQ(space::sign_at(deep, 0, Real(z)), sign) << z;
    EXPECT_EQ(space::sign_at(out, 0, Real(z)), -sign) << z;
  }
}

/// Of sets that touch in one point, or have a ball in common.
TEST(MeetSlack, IsTheRadiusOfABall) {
  const Tetrahedron about{{{-50, -50, -50}, {150, -50, -50}, {-50, 150, -50}, {-50, -50, 150}}};
  const auto slack = [&](std::vector<MeetSet> sets) { return meet_slack(sets, about, {}).value; };
  const MeetSet low{false, {0, 0, -1}, 0}, high{false, {0, 0, 1}, -4}, ball{true, {0, 0, 0}, 5},
      far{true, {9, 0, 0}, 5};
  EXPECT_NEAR(slack({low, high, ball}), 2, 1e-12);
  EXPECT_NEAR(slack({ball, far}), 0.5, 1e-12);
  EXPECT_NEAR(slack({ball, {true, {10, 0, 0}, 5}}), 0, 1e-12);
  EXPECT_NEAR(slack({ball, {true, {12, 0, 0}, 5}}), -1, 1e-12);
  // A ball in half a lens: as far from both spheres as from the plane.
  const double t = slack({ball, {true, {6, 0, 0}, 5}, low});
  EXPECT_NEAR(std::hypot(3, t), 5 - t, 1e-12);
}

}  // namespace distance_cut_depth
}  // namespace findspace::distance
