// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "distance/planar/directional.h"
#include "distance/planar/farthest.h"
#include "distance/planar/shape_pair.h"
#include "distance/planar_features/point_set.h"
#include "distance/planar_least/coordinate.h"
#include "distance/planar_least/distance_sum.h"
#include "distance/planar_least/extremum.h"
#include "distance/planar_least/level_extremum.h"
#include "distance/planar_least/level_probe.h"
#include "distance_shapes.h"
#include "plane/build/path_region.h"
#include "plane/query/summary.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::distance {
namespace distance_extremum {

using namespace findspace::testing;
using exact::Real;
using plane::CellComplex;
using plane::Region;

Extremum least_of(const ShapePair& pair, Which which) { return least(*pair.distance(which)); }

TEST(Least, Boxes) {
  ShapePair pair(box(-1, -1, 1, 1), box(-4, -3, 4, 3));
  Extremum e = least_of(pair, Which::kEta1);
  EXPECT_TRUE(e.proven());
  EXPECT_EQ(e.answer->value, Real(-2));
  EXPECT_DOUBLE_EQ(plane::summarize(e.at, 1).dangling_length, 2);
  Extremum g = least_of(pair, Which::kGamma2);
  EXPECT_EQ(g.answer->value * g.answer->value, Real(41));
  ASSERT_EQ(g.at.vertices.size(), 1u);
  EXPECT_FALSE(least_of(pair, Which::kDelta1).exists());
}

TEST(Least, InscribedCircleNextToASlit) {
  // distances.md D01: the inradius of U is 5 - 2 sqrt 3, that of X is 2.
  Region a = polygon({{0, -1}, {3, -1}, {3, 4}, {2, 4}, {2, 0}, {1, 0}, {1, 4}, {0, 4}});
  Extremum e = least_of(ShapePair(box(0, 0, 1, 2), a), Which::kGamma1);
  EXPECT_TRUE(e.proven());
  EXPECT_EQ(e.answer->value, Real(2) * sqrt(Real(3)) - Real(5));
  EXPECT_EQ(plane::summarize(e.at, 1).isolated.size(), 2u);
}

TEST(Least, WhereABisectorCrossesAnArc) {
  // A disc about two chained segments: the farthest points of its circle lie where a parabola crosses it.
  const std::array<exact::RealPoint, 3> chain{at(24, 25), at(30, 15), at(10, 16)};
  const ShapePair pair(plane::region_of_disc(0, 0, 12), plane::region_of_path(chain));
  const TDistancePointer mu = pair.distance(Which::kMu);
  const Extremum e = least(*mu);
  ASSERT_TRUE(e.exists() && e.proven() && e.attained);
  ASSERT_EQ(e.at.vertices.size(), 1u);
  const auto value = mu->value(e.at.geometry.exact(e.at.vertices[0].point));
  EXPECT_NEAR(value->value.to_double(), e.answer->value.to_double(), 1e-11);
}

/// The greater of the distances to two points, without what names its least value.
class Nameless : public TDistance {
 public:
  Nameless() : f_(ShapePair(point_set(std::array{at(0, 0)}), plane::region_of_path(kEnds)).distance(Which::kGamma2)) {}

  bool defined() const override { return true; }
  plane::SignMap sign_map(const Real& level) const override { return f_->sign_map(level); }
  std::optional<PlanarAnswer> value(const exact::RealPoint& p) const override { return f_->value(p); }
  exact::RealPoint seed() const override { return at(5, 5); }
  std::vector<NearLevelCurve> level_curves(const exact::RealPoint&, double) const override { return {}; }

 private:
  inline static const std::array<exact::RealPoint, 2> kEnds{at(0, 0), at(300, 100)};
  TDistancePointer f_;
};

TEST(Least, PlacesOfAnEnclosedValueAreToldFinely) {
  // Between opposite level curves, positions off by d are as good as d^2: a bracket of 2^-44 leaves them 1e-5 of play.
  const Nameless f;
  const Extremum e = least(f);
  ASSERT_TRUE(e.exists());
  ASSERT_FALSE(e.proven());
  EXPECT_TRUE(e.attained);
  EXPECT_LE(e.bound()->to_double(), std::hypot(150, 50) + 1e-13);
  EXPECT_NEAR(e.bound()->to_double(), e.answer->value.to_double(), 1e-10);
  EXPECT_LT(e.within, 300 * 1e-11);
  EXPECT_TRUE(plane::is_empty(distance::probe(f, *e.bound(), CellComplex::uniform(1), 1)));
  EXPECT_FALSE(plane::is_empty(distance::probe(f, e.answer->value, CellComplex::uniform(1), 1)));
  ASSERT_EQ(e.at.vertices.size(), 1u);
  const auto& p = e.at.geometry.points[e.at.vertices[0].point];
  EXPECT_LE(std::hypot(p.x - 150, p.y - 50), e.within + 1e-12);
}

/// Says much less at its seed than its sign maps.
class Understated : public Nameless {
 public:
  std::optional<PlanarAnswer> value(const exact::RealPoint& p) const override {
    auto v = Nameless::value(p);
    v->value = v->value - Real(1000000);
    return v;
  }
};

TEST(Least, AValueThatSaysTooLittleIsClimbedFrom) {
  const Extremum e = least(Understated());
  ASSERT_TRUE(e.exists());
  EXPECT_LE(e.bound()->to_double(), std::hypot(150, 50) + 1e-9);
  EXPECT_NEAR(e.answer->value.to_double(), std::hypot(150, 50), 1e-6);
}

/// The pair's distance as one that jumps would be looked for, over where the boxes are no farther than 7 from a wall.
TEST(Least, PositionsOfALevelAreAsNearAsTheyAreSaidToBe) {
  const Region a = box(0, 0, 10, 10), b = box(0, 0, 1, 1), wall = box(25, -100, 30, 100);
  const Region s = plane::remark(ShapePair(b, wall).distance(Which::kGamma1)->sign_map(7),
                                 [](plane::Mark m) { return plane::Mark(m <= 0); });
  const DirectionalSigned f(plane::contact_map(a, b), {1, 1, true});
  const Extremum e = level_extremum(f, s, Sense::kMinimum, false);
  ASSERT_TRUE(e.exists());
  ASSERT_FALSE(e.proven());
  EXPECT_NEAR(e.answer->value.to_double(), 7 * std::sqrt(2), 1e-6);
  EXPECT_EQ(e.answer->way, Way::kSearch);
  EXPECT_NEAR(e.within, 11, 1e-5);  // the segment x = 17, 6 <= y <= 17, from one of its ends
}

TEST(Least, OfASumThatEndsIsTakenFarAwayToo) {
  const ShapePair pair(plane::region_of_disc(0, 0, 5), plane::region_of_disc(0, 0, 15));
  const DistanceSum depth({{pair.distance(Which::kPenetration), Real(1)}});
  const Region all = CellComplex::uniform(1);
  const Extremum none = best_position(depth, {all, all}, Sense::kMinimum, 40);
  EXPECT_NEAR(none.answer->value.to_double(), 0, 1e-9);
  EXPECT_TRUE(std::isinf(none.within)) << "positions beyond all that is searched are as good";
  const Extremum most = best_position(depth, {all, all}, Sense::kMaximum, 40);
  EXPECT_NEAR(most.answer->value.to_double(), 20, 0.1);
  EXPECT_TRUE(std::isfinite(most.within));
}

TEST(Least, RoomBoundedByHollowArcs) {
  // The room for a triangle in a disc has three arcs of the disc's radius, which is more than its own inradius.
  ShapePair pair(polygon({{0, 0}, {3, -1}, {1, 3}}), plane::region_of_disc(-3, 1, 4));
  auto eta1 = pair.distance(Which::kEta1);
  EXPECT_EQ(eta1->sign_map(-3).faces.size(), 1u);
  Extremum e = least(*eta1);
  EXPECT_TRUE(e.proven());
  // The smallest circle around the triangle, right-angled at (0, 0), has radius sqrt 5.
  EXPECT_EQ(e.answer->value, sqrt(Real(5)) - Real(4));
}

TEST(Least, FatSetOfMinimisers) {
  Region a = polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}});
  Extremum e = least_of(ShapePair(box(-3, -3, 3, 3), a), Which::kHausdorff);
  EXPECT_TRUE(e.proven());
  EXPECT_EQ(e.answer->value, Real(1));
  EXPECT_NEAR(*plane::summarize(e.at, 1).area, M_PI, 1e-12);
}

TEST(Least, NoRoomForContainment) {
  Extremum e = least_of(ShapePair(box(0, 0, 3, 1), box(0, 0, 1, 10)), Which::kMu);
  EXPECT_EQ(e.answer->value, Real(1));
  EXPECT_DOUBLE_EQ(plane::summarize(e.at, 1).dangling_length, 9);
}

TEST(Least, ConstantDistance) {
  Extremum e = least_of(ShapePair(box(0, 0, 3, 1), box(0, 0, 1, 10)), Which::kDstar);
  EXPECT_EQ(e.answer->value, Real(0));
  EXPECT_TRUE(plane::is_whole(e.at));
}

TEST(Least, SmallestCircleAroundDiscs) {
  Region discs[] = {plane::region_of_disc(0, 0, 1), plane::region_of_disc(10, 0, 3)};
  std::vector<const Region*> both{&discs[0], &discs[1]};
  Region a = plane::unite(both), b = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}});
  Extremum e = least_of(ShapePair(b, a), Which::kGamma2);
  EXPECT_TRUE(e.proven());
  EXPECT_EQ(e.answer->value, Real(7));
}

TEST(Constrained, GammaTwoOnAContour) {
  // distances.md F16.
  ShapePair pair(box(-1, -1, 1, 1), box(-4, -3, 4, 3));
  Region s =
      plane::remark(pair.distance(Which::kGamma1)->sign_map(1), [](plane::Mark m) { return plane::Mark(m == 0); });
  Extremum e = extremum(*pair.distance(Which::kGamma2), s, Sense::kMinimum);
  EXPECT_TRUE(e.proven());
  EXPECT_TRUE(e.attained);
  EXPECT_EQ(e.answer->value * e.answer->value, Real(106));
  EXPECT_EQ(plane::summarize(e.at, 1).isolated.size(), 2u);
}

TEST(Constrained, InfimumOverAnOpenSet) {
  Region open = plane::interior(box(2, 1, 5, 4));
  Extremum e = extremum(Farthest::from_point(at(0, 0)), open, Sense::kMinimum);
  EXPECT_TRUE(e.exists());
  EXPECT_FALSE(e.attained);
  EXPECT_EQ(e.answer->value * e.answer->value, Real(5));
  Extremum most = extremum(Farthest::from_point(at(0, 0)), open, Sense::kMaximum);
  EXPECT_EQ(most.answer->value * most.answer->value, Real(41));
  EXPECT_TRUE(extremum(Farthest::from_point(at(0, 0)), plane::complement(open), Sense::kMaximum).unbounded);
  EXPECT_FALSE(extremum(Farthest::from_point(at(0, 0)), plane::CellComplex::uniform(0), Sense::kMinimum).exists());
}

TEST(Constrained, LargestGapInABox) {
  // The point of the box farthest from four corners is its middle.
  Region a = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}, {6, 0}, {6, 8}, {0, 8}});
  Region b = plane::region_of_points(std::vector<plane::GridPoint>{{0, 0}});
  Extremum e = extremum(*ShapePair(b, a).distance(Which::kGamma1), box(0, 0, 6, 8), Sense::kMaximum);
  EXPECT_TRUE(e.proven());
  EXPECT_EQ(e.answer->value, Real(5));
}

TEST(Constrained, GreatestOverAllPositions) {
  const Region all = CellComplex::uniform(1);
  const ShapePair boxes(box(-1, -1, 1, 1), box(0, 0, 10, 10));
  EXPECT_TRUE(extremum(*boxes.distance(Which::kGamma1), all, Sense::kMaximum).unbounded);
  // From the middle the way out is half of 10 and half of 2.
  const Extremum depth = extremum(*boxes.distance(Which::kPenetration), all, Sense::kMaximum);
  ASSERT_TRUE(depth.exists() && depth.proven() && depth.attained);
  EXPECT_EQ(depth.answer->value, Real(6));
  ASSERT_EQ(depth.at.vertices.size(), 1u);
  EXPECT_EQ(depth.at.geometry.exact(depth.at.vertices[0].point).x, Real(5));
  // Beyond a wall about it there is none: 0 is the greatest, all the way.
  const Extremum apart =
      extremum(*boxes.distance(Which::kPenetration), plane::complement(box(-5, -5, 15, 15)), Sense::kMaximum);
  ASSERT_TRUE(apart.exists() && apart.proven() && apart.attained);
  EXPECT_EQ(apart.answer->value, Real());
}

TEST(Constrained, GreatestGapInAHole) {
  // In a hole of 10 by 6 a box of 2 by 2 is 2 from the sides along a segment; outside of the hole the gap is negative.
  const ShapePair pair(box(-1, -1, 1, 1), plane::closure(plane::complement(box(-5, -3, 5, 3))));
  const Extremum gap = extremum(*pair.distance(Which::kGamma1), CellComplex::uniform(1), Sense::kMaximum);
  ASSERT_TRUE(gap.exists() && gap.proven() && gap.attained);
  EXPECT_EQ(gap.answer->value, Real(2));
  EXPECT_DOUBLE_EQ(plane::summarize(gap.at, 1).dangling_length, 4);
}

TEST(Coordinate, EdgesPointsAndOpenEnds) {
  Extremum e = linear_extremum(box(0, 1, 4, 3), kY, Sense::kMinimum);
  EXPECT_EQ(e.answer->value, Real(1));
  EXPECT_TRUE(e.attained);
  EXPECT_DOUBLE_EQ(plane::summarize(e.at, 1).dangling_length, 4);
  Extremum top = linear_extremum(plane::interior(plane::region_of_disc(0, 0, 5)), kY, Sense::kMaximum);
  EXPECT_EQ(top.answer->value, Real(5));
  EXPECT_FALSE(top.attained);
  EXPECT_EQ(top.at.vertices.size(), 1u);
  EXPECT_TRUE(linear_extremum(plane::complement(box(0, 0, 1, 1)), kX, Sense::kMinimum).unbounded);
}

}  // namespace distance_extremum
}  // namespace findspace::distance
