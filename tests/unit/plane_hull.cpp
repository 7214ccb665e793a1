// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "findspace/error.h"
#include "law/plane_random.h"
#include "plane/build/hull.h"
#include "plane/query/locate.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace plane_hull {

using exact::Real;
using Kind = Shape::Kind;

ShapePtr both(const ShapePtr& a, const ShapePtr& b) { return node(Kind::kUnion, {a, b}); }
ShapePtr open_set(const ShapePtr& a) { return node(Kind::kInterior, {a}); }

int mark_at(const Region& s, const Real& x, const Real& y) {
  exact::RealPoint p{x, y};
  return mark_of(s, locate(s, p));
}

void expect_hull(const ShapePtr& shape, const ShapePtr& expected) {
  Region h = hull(region_of(shape));
  EXPECT_EQ(fault(h), "") << show(*shape);
  EXPECT_TRUE(same_set(h, region_of(expected))) << show(*shape);
}

TEST(Hull, EmptySetPlaneAndUnboundedSets) {
  EXPECT_TRUE(is_empty(hull(Region::uniform(0))));
  EXPECT_TRUE(is_whole(hull(Region::uniform(1))));
  EXPECT_TRUE(is_whole(hull(complement(region_of(box_of(0, 0, 5, 5))))));
}

TEST(Hull, Points) {
  expect_hull(points_of({{3, 4}}), points_of({{3, 4}}));
  expect_hull(points_of({{3, 4}, {1, 2}}), chain_of({{1, 2}, {3, 4}}));
  expect_hull(points_of({{3, 4}, {1, 2}, {5, 6}, {2, 3}}), chain_of({{1, 2}, {5, 6}}));
  expect_hull(points_of({{0, 0}, {0, 4}, {0, 2}}), chain_of({{0, 0}, {0, 4}}));
  expect_hull(points_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {2, 2}}), box_of(0, 0, 4, 4));
}

TEST(Hull, OpenSegmentStaysOpen) {
  ShapePtr open = node(Kind::kDifference, {chain_of({{0, 0}, {6, 3}}), points_of({{0, 0}, {2, 1}, {6, 3}})});
  expect_hull(open, node(Kind::kDifference, {chain_of({{0, 0}, {6, 3}}), points_of({{0, 0}, {6, 3}})}));
}

TEST(Hull, Polygons) {
  expect_hull(polygon_of({{0, 0}, {9, 0}, {9, 9}, {5, 2}, {0, 9}}), box_of(0, 0, 9, 9));
  expect_hull(both(box_of(0, 0, 2, 2), box_of(5, 5, 7, 7)),
              polygon_of({{0, 0}, {2, 0}, {7, 5}, {7, 7}, {5, 7}, {0, 2}}));
  expect_hull(chain_of({{0, 0}, {4, 0}, {4, 4}}), polygon_of({{0, 0}, {4, 0}, {4, 4}}));
}

TEST(Hull, ComputedCornersWithSmallDirections) {
  // The triangles meet at (2, 1) +- halves; their intersection is a polygon with computed corners.
  ShapePtr set =
      node(Kind::kIntersection, {polygon_of({{0, 0}, {4, 0}, {2, 3}}), polygon_of({{0, 2}, {4, 2}, {2, -1}})});
  expect_hull(set, set);
}

TEST(Hull, ComputedCornersWithLargeDirectionsAreRefused) {
  const std::int64_t n = 1000003;
  ShapePtr part = node(Kind::kIntersection,
                       {polygon_of({{0, 0}, {n, 17}, {n - 5, n + 11}}), polygon_of({{3, n}, {7, -n}, {n + 9, 5}})});
  ShapePtr set = both(part, translate_of(node(Kind::kMirror, {part}), {3 * n, 7}));
  try {
    hull(region_of(set));
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kUnsupported);
  }
}

TEST(Hull, Discs) {
  expect_hull(disc_of({2, 3}, sqrt(Real(2))), disc_of({2, 3}, sqrt(Real(2))));
  expect_hull(open_set(disc_of({2, 3}, 2)), open_set(disc_of({2, 3}, 2)));
  expect_hull(node(Kind::kBoundary, {disc_of({2, 3}, 2)}), disc_of({2, 3}, 2));
  expect_hull(both(disc_of({0, 0}, 5), disc_of({1, 1}, 2)), disc_of({0, 0}, 5));
  expect_hull(both(disc_of({0, 0}, 5), disc_of({2, 0}, 3)), disc_of({0, 0}, 5));  // touching inside
  expect_hull(both(disc_of({0, 0}, 5), points_of({{3, 4}, {0, -5}, {5, 0}})),
              disc_of({0, 0}, 5));  // points on the circle
}

TEST(Hull, DiscsOfOneRadius) {
  for (const Real& r : {Real(1), Real::ratio(5, 2), sqrt(Real(3))}) {
    std::vector<GridPoint> centers{{0, 0}, {7, 1}, {9, 6}, {3, 8}, {4, 4}, {0, 4}, {0, 8}};
    std::vector<ShapePtr> discs;
    for (const GridPoint& c : centers) discs.push_back(disc_of(c, r));
    ShapePtr points = points_of(centers);
    expect_hull(node(Kind::kUnion, discs),
                node(Kind::kMinkowskiSum, {node(Kind::kHull, {points}), disc_of({0, 0}, r)}));
  }
}

TEST(Hull, TwoDiscsAreAStadium) {
  expect_hull(both(disc_of({0, 0}, 2), disc_of({7, 0}, 2)),
              node(Kind::kUnion, {disc_of({0, 0}, 2), disc_of({7, 0}, 2), box_of(0, -2, 7, 2)}));
}

TEST(Hull, HalfDiscAndSegment) {
  ShapePtr half = node(Kind::kIntersection, {disc_of({0, 0}, 5), box_of(-9, 0, 9, 9)});
  expect_hull(half, half);
  ShapePtr arc = node(Kind::kIntersection, {node(Kind::kBoundary, {disc_of({0, 0}, 5)}), box_of(-9, 0, 9, 9)});
  expect_hull(arc, half);
  ShapePtr quarter = node(Kind::kIntersection, {node(Kind::kBoundary, {disc_of({0, 0}, 5)}), box_of(0, 0, 9, 9)});
  expect_hull(quarter, node(Kind::kDifference, {node(Kind::kIntersection, {disc_of({0, 0}, 5), box_of(0, 0, 9, 9)}),
                                                open_set(polygon_of({{-1, -1}, {6, -1}, {-1, 6}}))}));
}

TEST(Hull, TangentWithIntegerDirection) {
  // From (5, 0) to the circle about 0 of radius 3: along (-4, 3) and (-4, -3), touching at (9/5, +-12/5).
  Region h = hull(region_of(both(disc_of({0, 0}, 3), points_of({{5, 0}}))));
  EXPECT_EQ(fault(h), "");
  EXPECT_EQ(mark_at(h, Real::ratio(34, 10), Real::ratio(12, 10)), 1);
  EXPECT_EQ(mark_at(h, Real::ratio(34, 10), Real::ratio(1201, 1000)), 0);
  EXPECT_EQ(mark_at(h, 0, -3), 1);
  EXPECT_EQ(h.edges.size(), 4u);  // two sides, and the arc cut at its leftmost point
}

TEST(Hull, IrrationalTangentIsRefused) {
  EXPECT_THROW(hull(region_of(both(disc_of({0, 0}, 3), disc_of({10, 0}, 2)))), Error);
  EXPECT_THROW(hull(region_of(both(disc_of({0, 0}, 3), points_of({{6, 0}})))), Error);
  // Four fifths: radii 3 and 7, centres 5 apart.
  EXPECT_NO_THROW(hull(region_of(both(disc_of({0, 0}, 3), disc_of({5, 0}, 7)))));
}

TEST(Hull, OpenSetsHaveOpenHulls) {
  ShapePtr two = both(box_of(0, 0, 2, 2), box_of(5, 5, 7, 7));
  expect_hull(open_set(two), open_set(node(Kind::kHull, {two})));
  ShapePtr discs = both(disc_of({0, 0}, 2), disc_of({6, 3}, 2));
  expect_hull(open_set(discs), open_set(node(Kind::kHull, {discs})));
}

TEST(Hull, PartsOfSidesBelong) {
  // An open square with points of its lower side: what lies between them belongs to the hull.
  ShapePtr open = open_set(box_of(0, 0, 9, 9));
  expect_hull(both(open, points_of({{2, 0}, {4, 0}, {5, 0}})), both(open, chain_of({{2, 0}, {5, 0}})));
  expect_hull(both(open, points_of({{4, 0}})), both(open, points_of({{4, 0}})));
  expect_hull(both(open, points_of({{0, 0}, {9, 9}})), both(open, points_of({{0, 0}, {9, 9}})));
  ShapePtr pieces =
      node(Kind::kDifference, {both(chain_of({{1, 0}, {3, 0}}), chain_of({{5, 0}, {6, 0}})), points_of({{1, 0}})});
  expect_hull(both(open, pieces),
              node(Kind::kDifference, {both(open, chain_of({{1, 0}, {6, 0}})), points_of({{1, 0}})}));
}

TEST(Hull, PartsOfArcsBelong) {
  ShapePtr circle = node(Kind::kBoundary, {disc_of({0, 0}, 5)});
  ShapePtr some = node(Kind::kIntersection,
                       {circle, node(Kind::kUnion, {box_of(3, 3, 9, 9), points_of({{0, 5}, {-5, 0}, {-4, -3}})})});
  ShapePtr set = both(open_set(disc_of({0, 0}, 5)), some);
  expect_hull(set, set);
}

TEST(Hull, MiddleArcTouchesASide) {
  // Three discs in a row; only the middle one has its lowest point.
  ShapePtr discs = node(Kind::kUnion, {disc_of({0, 0}, 2), disc_of({6, 0}, 2), disc_of({12, 0}, 2)});
  ShapePtr open = open_set(discs);
  Region h = hull(region_of(both(open, points_of({{6, -2}}))));
  EXPECT_EQ(fault(h), "");
  EXPECT_EQ(mark_at(h, 6, -2), 1);
  EXPECT_EQ(mark_at(h, 5, -2), 0);
  EXPECT_EQ(mark_at(h, 0, -2), 0);
  EXPECT_EQ(mark_at(h, 6, 2), 0);
  Region g = hull(region_of(both(open, both(disc_of({6, 0}, 2), points_of({{12, -2}})))));
  EXPECT_EQ(mark_at(g, 6, -2), 1);
  EXPECT_EQ(mark_at(g, 9, -2), 1);
  EXPECT_EQ(mark_at(g, 12, -2), 1);
  EXPECT_EQ(mark_at(g, 5, -2), 0);
  EXPECT_EQ(mark_at(g, 6, 2), 1);
}

}  // namespace plane_hull
}  // namespace findspace::plane
