// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "distance/coordinate.h"
#include "distance/extremum.h"
#include "distance/farthest.h"
#include "distance/shape_pair.h"
#include "distance_shapes.h"
#include "plane/path_region.h"
#include "plane/summary.h"
#include "plane/topology.h"

namespace findspace::distance {
namespace {

using namespace findspace::testing;
using exact::Real;
using plane::Region;

Extremum least_of(const ShapePair& pair, Which which) { return least(*pair.distance(which)); }

TEST(Least, Boxes) {
  ShapePair pair(box(-1, -1, 1, 1), box(-4, -3, 4, 3));
  Extremum e = least_of(pair, Which::kEta1);
  EXPECT_TRUE(e.proven);
  EXPECT_EQ(e.level, Real(-2));
  EXPECT_DOUBLE_EQ(plane::summarize(e.at, 1).dangling_length, 2);
  Extremum g = least_of(pair, Which::kGamma2);
  EXPECT_EQ(g.level * g.level, Real(41));
  ASSERT_EQ(g.at.vertices.size(), 1u);
  EXPECT_FALSE(least_of(pair, Which::kDelta1).exists);
}

TEST(Least, InscribedCircleNextToASlit) {
  // distances.md D01: the inradius of U is 5 - 2 sqrt 3, that of X is 2.
  Region a = polygon({{0, -1}, {3, -1}, {3, 4}, {2, 4}, {2, 0}, {1, 0}, {1, 4}, {0, 4}});
  Extremum e = least_of(ShapePair(box(0, 0, 1, 2), a), Which::kGamma1);
  EXPECT_TRUE(e.proven);
  EXPECT_EQ(e.level, Real(2) * sqrt(Real(3)) - Real(5));
  EXPECT_EQ(plane::summarize(e.at, 1).isolated.size(), 2u);
}

TEST(Least, WhatNoSquareRootNamesIsEnclosed) {
  // A disc about two chained segments: the farthest points of its circle lie where a parabola crosses it.
  const std::array<exact::RealPoint, 3> chain{at(24, 25), at(30, 15), at(10, 16)};
  const ShapePair pair(plane::region_of_disc(0, 0, 12), plane::region_of_path(chain));
  const TDistancePointer mu = pair.distance(Which::kMu);
  const Extremum e = least(*mu);
  ASSERT_TRUE(e.exists);
  ASSERT_FALSE(e.proven);
  EXPECT_TRUE(e.attained);
  const double level = e.level.to_double();
  EXPECT_LT(e.bound, level);
  EXPECT_LT(level - e.bound, level * 1e-12);
  const auto below = mu->sign_map(Real::from_double(e.bound)), reached = mu->sign_map(e.level);
  const auto some = [](const plane::SignMap& m) {
    return std::any_of(m.vertices.begin(), m.vertices.end(), [](const auto& v) { return v.mark <= 0; });
  };
  EXPECT_FALSE(some(below));
  EXPECT_TRUE(some(reached));
  EXPECT_LT(e.within, 1e-4);
  for (const auto& v : reached.vertices) {
    const auto& p = reached.geometry.points[v.point];
    double least = 1e9;
    for (const auto& w : e.at.vertices) {
      const auto& q = e.at.geometry.points[w.point];
      least = std::min(least, std::hypot(p.x - q.x, p.y - q.y));
    }
    EXPECT_TRUE(v.mark > 0 || least <= e.within);
  }
}

TEST(Least, RoomBoundedByHollowArcs) {
  // The room for a triangle in a disc has three arcs of the disc's radius, which is more than its own inradius.
  ShapePair pair(polygon({{0, 0}, {3, -1}, {1, 3}}), plane::region_of_disc(-3, 1, 4));
  auto eta1 = pair.distance(Which::kEta1);
  EXPECT_EQ(eta1->sign_map(-3).faces.size(), 1u);
  Extremum e = least(*eta1);
  EXPECT_TRUE(e.proven);
  // The smallest circle around the triangle, right-angled at (0, 0), has radius sqrt 5.
  EXPECT_EQ(e.level, sqrt(Real(5)) - Real(4));
}

TEST(Least, FatSetOfMinimisers) {
  Region a = polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}});
  Extremum e = least_of(ShapePair(box(-3, -3, 3, 3), a), Which::kHausdorff);
  EXPECT_TRUE(e.proven);
  EXPECT_EQ(e.level, Real(1));
  EXPECT_NEAR(*plane::summarize(e.at, 1).area, M_PI, 1e-12);
}

TEST(Least, NoRoomForContainment) {
  Extremum e = least_of(ShapePair(box(0, 0, 3, 1), box(0, 0, 1, 10)), Which::kMu);
  EXPECT_EQ(e.level, Real(1));
  EXPECT_DOUBLE_EQ(plane::summarize(e.at, 1).dangling_length, 9);
}

TEST(Least, ConstantDistance) {
  Extremum e = least_of(ShapePair(box(0, 0, 3, 1), box(0, 0, 1, 10)), Which::kDstar);
  EXPECT_EQ(e.level, Real(0));
  EXPECT_TRUE(plane::is_whole(e.at));
}

TEST(Least, SmallestCircleAroundDiscs) {
  Region discs[] = {plane::region_of_disc(0, 0, 1), plane::region_of_disc(10, 0, 3)};
  std::vector<const Region*> both{&discs[0], &discs[1]};
  Region a = plane::unite(both), b = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}});
  Extremum e = least_of(ShapePair(b, a), Which::kGamma2);
  EXPECT_TRUE(e.proven);
  EXPECT_EQ(e.level, Real(7));
}

TEST(Constrained, GammaTwoOnAContour) {
  // distances.md F16.
  ShapePair pair(box(-1, -1, 1, 1), box(-4, -3, 4, 3));
  Region s =
      plane::remark(pair.distance(Which::kGamma1)->sign_map(1), [](plane::Mark m) { return plane::Mark(m == 0); });
  Extremum e = extremum(*pair.distance(Which::kGamma2), s, Sense::kMinimum);
  EXPECT_TRUE(e.proven);
  EXPECT_TRUE(e.attained);
  EXPECT_EQ(e.level * e.level, Real(106));
  EXPECT_EQ(plane::summarize(e.at, 1).isolated.size(), 2u);
}

TEST(Constrained, InfimumOverAnOpenSet) {
  Region open = plane::interior(box(2, 1, 5, 4));
  Extremum e = extremum(Farthest::from_point(at(0, 0)), open, Sense::kMinimum);
  EXPECT_TRUE(e.exists);
  EXPECT_FALSE(e.attained);
  EXPECT_EQ(e.level * e.level, Real(5));
  Extremum most = extremum(Farthest::from_point(at(0, 0)), open, Sense::kMaximum);
  EXPECT_EQ(most.level * most.level, Real(41));
  EXPECT_TRUE(extremum(Farthest::from_point(at(0, 0)), plane::complement(open), Sense::kMaximum).unbounded);
  EXPECT_FALSE(extremum(Farthest::from_point(at(0, 0)), plane::CellComplex::uniform(0), Sense::kMinimum).exists);
}

TEST(Constrained, LargestGapInABox) {
  // The point of the box farthest from four corners is its middle.
  Region a = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}, {6, 0}, {6, 8}, {0, 8}});
  Region b = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}});
  Extremum e = extremum(*ShapePair(b, a).distance(Which::kGamma1), box(0, 0, 6, 8), Sense::kMaximum);
  EXPECT_TRUE(e.proven);
  EXPECT_EQ(e.level, Real(5));
}

TEST(Coordinate, EdgesPointsAndOpenEnds) {
  Extremum e = linear_extremum(box(0, 1, 4, 3), kY, Sense::kMinimum);
  EXPECT_EQ(e.level, Real(1));
  EXPECT_TRUE(e.attained);
  EXPECT_DOUBLE_EQ(plane::summarize(e.at, 1).dangling_length, 4);
  Extremum top = linear_extremum(plane::interior(plane::region_of_disc(0, 0, 5)), kY, Sense::kMaximum);
  EXPECT_EQ(top.level, Real(5));
  EXPECT_FALSE(top.attained);
  EXPECT_EQ(top.at.vertices.size(), 1u);
  EXPECT_TRUE(linear_extremum(plane::complement(box(0, 0, 1, 1)), kX, Sense::kMinimum).unbounded);
}

}  // namespace
}  // namespace findspace::distance
