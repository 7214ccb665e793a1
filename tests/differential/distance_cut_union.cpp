// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How a body fits into a union of solids that balls are cut out of or that are cut off by them, against places of the
// body and positions all over.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "distance/csg/csg_pair.h"
#include "unit/cut_cases.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_cut_union {

using exact::Real;
using space::ball;
using space::node;
using space::RealVector;
using Kind = plane::Shape::Kind;

/// Two domes side by side, and two bowls that lie over each other.
std::vector<Case> unions() {
  const ShapePtr ground = box({-40, -40, 0}, {40, 40, 40});
  const auto dome = [](const Vector& x, double at) { return std::max(to_ball(x, {at, 0, 0}, 12), -x.z); };
  const auto bowl = [](const Vector& x, double at) {
    return std::max(to_box(x, {at - 10, -10, -10}, {at + 10, 10, 10}), -to_ball(x, {at, 0, 10}, 6));
  };
  const auto bowl_at = [](std::int64_t at) {
    return node(Kind::kDifference, {box({at - 10, -10, -10}, {at + 10, 10, 10}), ball({at, 0, 10}, 6)});
  };
  return {{"domes",
           node(Kind::kUnion, {node(Kind::kIntersection, {ball({-6, 0, 0}, 12), ground}),
                               node(Kind::kIntersection, {ball({6, 0, 0}, 12), ground})}),
           [=](const Vector& x) { return std::min(dome(x, -6), dome(x, 6)); }},
          {"bowls", node(Kind::kUnion, {bowl_at(-4), bowl_at(5)}),
           [=](const Vector& x) { return std::min(bowl(x, -4), bowl(x, 5)); }}};
}

/// Places of the cube, up to its corners.
std::vector<Vector> of_cube() {
  std::vector<Vector> out;
  for (int i = 0; i < 729; ++i) out.push_back({(i % 9 - 4) * 0.75, (i / 9 % 9 - 4) * 0.75, (i / 81 - 4) * 0.75});
  return out;
}

std::shared_ptr<const CsgSide> side_of(const Case& c) {
  return std::make_shared<const CsgSide>(space::shared(space::body(*box({-3, -3, -3}, {3, 3, 3}))),
                                         std::make_shared<const space::CsgSolid>(space::csg_solid(*c.shape)));
}

TEST(CutUnion, HoldsWhatItsSamplesSay) {
  std::mt19937 random(3);
  const std::vector<Vector> cube = of_cube();
  {
    const Case c = unions()[0];
    const auto fits = [&](const Vector& p, double by) {
      return std::all_of(cube.begin(), cube.end(), [&](const Vector& x) { return c.level(space::plus(x, p)) <= by; });
    };
    std::vector<Vector> all;
    for (int k = 0; k < 60000; ++k) {
      const Vector q = any(random, 18);
      if (fits(q, 0)) all.push_back(q);
    }
    ASSERT_GT(all.size(), 300u) << c.name;
    const PairDistances pair = csg_pair(side_of(c), false);
    int in = 0;
    for (int k = 0; k < 10; ++k) {
      const Vector p = k < 3 ? all[static_cast<std::size_t>(k)] : any(random, 22);
      const RealVector at{Real::from_double(p.x), Real::from_double(p.y), Real::from_double(p.z)};
      double least = exact::kInfinity, most = 0;
      for (const Vector& q : all) {
        least = std::min(least, space::length(q - p));
        most = std::max(most, space::length(q - p));
      }
      const Answer v = *pair.value(Which::kEta1, at), far = *pair.value(Which::kEta2, at);
      EXPECT_EQ(v.value.sign() <= 0, fits(p, 0)) << c.name;
      EXPECT_LE(v.value.to_double(), least + 1e-9) << c.name;
      EXPECT_GE(far.value.to_double(), most - 1e-9) << c.name;
      EXPECT_LE(far.value.to_double(), most + 2) << c.name;
      if (v.value.sign() > 0) {
        EXPECT_GE(v.value.to_double(), least - 2) << c.name;
        ASSERT_TRUE(v.nearest);
        EXPECT_TRUE(fits(space::rounded(*v.nearest), 1e-9)) << c.name;
        const Answer out = *pair.value(Which::kMu, at);
        EXPECT_GT(out.value.sign(), 0) << c.name;
        EXPECT_LE(out.bounds().lower->to_double(), v.value.to_double() + 1e-9) << c.name;  // no sign: test
        continue;
      }
      ++in;
      EXPECT_EQ(pair.value(Which::kMu, at)->value, v.value) << c.name;
      Vector way = any(random, 1);
      way = space::scaled(-0.99 * v.value.to_double() / space::length(way), way);
      EXPECT_TRUE(fits(space::plus(p, way), 1e-9)) << c.name;
    }
    EXPECT_GT(in, 1) << c.name;
  }
}

/// Of bowls: out of both pockets, and from outside to a face.
TEST(CutUnion, HasPockets) {
  const PairDistances pair = csg_pair(side_of(unions()[1]), false);
  const auto eta = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    return pair.value(Which::kEta1, space::place(x, y, z))->value.to_double();
  };
  EXPECT_NEAR(eta(0, 14, 3), 7, 1e-10);
  EXPECT_NEAR(eta(-15, 3, -4), 4, 1e-10);
  EXPECT_NEAR(eta(-15, 3, 0), 4, 1e-10);
  EXPECT_NEAR(eta(0, 0, -4), -3, 1e-10);
  // Below the place where both pockets meet, at (1/2, 0).
  const double up = pair.value(Which::kEta1, space::place(0, 0, 5))->value.to_double();
  EXPECT_GT(up, 1.5);
  EXPECT_LT(up, 2.5);
}

TEST(CutUnion, HasLines) {
  const auto side = side_of(unions()[0]);
  // Two above the ground; the upper corners reach |x| = 6 + sqrt(144 - 9 - 64).
  const space::RayGrid grid{0, 1, 0, 5, 1, 1, 1, 1};
  const space::RayRow row = cut_map(Which::kEta1, Real(), side, 1, grid)->row(0);
  const double end = 3 + std::sqrt(71.0);
  EXPECT_EQ(space::sign_at(row, 0, Real(0)), -1);
  for (const double off : {-0.01, 0.01}) {
    EXPECT_EQ(space::sign_at(row, 0, Real::from_double(end + off)), off < 0 ? -1 : 1);
    EXPECT_EQ(space::sign_at(row, 0, Real::from_double(-end - off)), off < 0 ? -1 : 1);
  }
}

/// Nothing as large as that fits, though the box about the domes would hold it.
TEST(CutUnion, MayBeTooSmall) {
  const CsgSide side(space::shared(space::body(*box({-9, -9, -5}, {9, 9, 5}))),
                     std::make_shared<const space::CsgSolid>(space::csg_solid(*unions()[0].shape)));
  EXPECT_FALSE(side.fit(space::place(0, 0, 0)).or_throw());
  EXPECT_FALSE(side.farthest_fit(space::place(0, 0, 0)).or_throw());
}

}  // namespace distance_cut_union
}  // namespace findspace::distance
