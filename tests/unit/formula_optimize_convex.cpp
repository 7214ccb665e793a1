// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Extrema over a convex set, on a line, and over rays through a region.
#include <gtest/gtest.h>

#include "formula/solid/optimize_convex.h"
#include "formula/solid/optimize_line.h"
#include "space/rays/piece_rays.h"
#include "space/rays/ray_extreme.h"
#include "unit/space_bodies.h"

namespace findspace::formula {
namespace formula_optimize_convex {

using distance::Sense;
using exact::Real;
using space::ConvexRegion;
using space::ConvexSet;
using space::HalfSpace;
using space::place;

/// x, y, z >= 0, x + y + z <= 6.
ConvexSet tetrahedron(bool inside, bool frontier) {
  ConvexSet set{ConvexRegion(place(0, 0, 0), place(6, 6, 6)), inside, frontier, false, {}};
  set.region.cut(HalfSpace(place(1, 1, 1), Real(-6)));
  return set;
}

Objective coordinate(Objective::Kind kind) {
  Objective o;
  o.kind = kind;
  return o;
}

TEST(OptimizeConvex, CoordinatesAndDistances) {
  const auto least = optimize(tetrahedron(true, true), Real(1), coordinate(Objective::Kind::kZ), Sense::kMinimum);
  ASSERT_TRUE(least && least->exists());
  EXPECT_EQ(*least->value(), Real(0));
  EXPECT_TRUE(least->attained);
  EXPECT_EQ(least->answer->way, distance::Way::kConvex);
  EXPECT_EQ(least->at.region.dimension(), 2);
  const auto top =
      optimize(tetrahedron(true, false), Real::ratio(1, 2), coordinate(Objective::Kind::kX), Sense::kMaximum);
  EXPECT_EQ(*top->value(), Real(3));
  EXPECT_FALSE(top->attained);
  EXPECT_EQ(top->at.region.vertices()[0].at, place(6, 0, 0));
  Objective near = coordinate(Objective::Kind::kDistanceToPoint);
  near.point = {Real(4), Real(4), Real(4)};
  const auto projection = optimize(tetrahedron(true, true), Real(1), near, Sense::kMinimum);
  EXPECT_EQ(*projection->value(), sqrt(Real(12)));
  EXPECT_EQ(projection->at.region.vertices()[0].at, place(2, 2, 2));
  EXPECT_FALSE(optimize(tetrahedron(true, true), Real(1), near, Sense::kMaximum));
  ConvexSet nothing = tetrahedron(true, true);
  nothing.region.cut(HalfSpace(place(1, 0, 0), Real(1)));
  EXPECT_FALSE(optimize(nothing, Real(1), near, Sense::kMinimum)->exists());
}

TEST(OptimizeLine, SaysOnWhichSideItsValueIsCertain) {
  const std::vector<plane::LineInterval> set{{Real(2), Real(5), true, true}};
  const SpaceLine line{place(0, 0, 0), place(0, 0, 1)};
  const auto least = [&](Side side) {
    return optimize(set, line, Real(1), coordinate(Objective::Kind::kZ), Sense::kMinimum, side);
  };
  EXPECT_TRUE(least(Side::kExact).proven());
  EXPECT_TRUE(least(Side::kExact).attained);
  EXPECT_EQ(least(Side::kInner).answer->side, Side::kInner);
  EXPECT_FALSE(least(Side::kInner).bound());
  EXPECT_EQ(least(Side::kOuter).answer->side, Side::kNone);
  EXPECT_EQ(*least(Side::kOuter).bound(), Real(2));
  EXPECT_FALSE(least(Side::kOuter).attained);
  EXPECT_FALSE(least(Side::kMixed).bound());
  for (const Side side : {Side::kExact, Side::kInner, Side::kOuter, Side::kMixed})
    EXPECT_EQ(*least(side).value(), Real(2));
}

TEST(RayExtreme, OfABallOnLines) {
  const space::RayGrid grid{2, 1, -4, -4, 1, 1, 9, 9};
  const space::PieceRays ball({space::ball_piece({}, Real(3))}, 1, grid);
  const auto extreme = [&](const space::RayAim& aim) {
    space::RayExtreme out(aim, {-4, -4, -4}, {4, 4, 4});
    for (int j = 0; j < grid.nv; ++j) out.add(grid, j, ball.row(j));
    return *out.found();
  };
  EXPECT_EQ(extreme({2, true, {}}).value, 3);
  EXPECT_EQ(extreme({2, false, {}}).value, -3);
  EXPECT_TRUE(extreme({2, false, {}}).attained);
  EXPECT_EQ(extreme({0, true, {}}).at[0], 3);  // a line that touches
  EXPECT_EQ(extreme({-1, false, {0, 0, 7}}).value, 4);
  EXPECT_EQ(extreme({-1, false, {1, 1, 1}}).value, 0);
  space::RayExtreme none({0, true, {}}, {}, {});
  EXPECT_FALSE(none.found());
}

}  // namespace formula_optimize_convex
}  // namespace findspace::formula
