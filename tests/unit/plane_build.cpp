// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "findspace/error.h"
#include "law/plane_random.h"
#include "plane/build/build.h"
#include "plane/query/locate.h"

namespace findspace::plane {
namespace plane_build {

using exact::Real;
using Kind = Shape::Kind;

int mark_at(const Region& s, const Real& x, const Real& y) {
  exact::RealPoint p{x, y};
  return mark_of(s, locate(s, p));
}

void expect_same(const ShapePtr& left, const ShapePtr& right) {
  Region a = region_of(left), b = region_of(right);
  EXPECT_EQ(fault(a), "") << show(*left);
  EXPECT_EQ(fault(b), "") << show(*right);
  EXPECT_TRUE(same_set(a, b)) << show(*left) << "\n" << show(*right);
}

ShapePtr nothing() { return node(Kind::kDifference, {box_of(0, 0, 1, 1), box_of(0, 0, 1, 1)}); }
ShapePtr plane() { return node(Kind::kComplement, {nothing()}); }

TEST(Build, EmptySetAndPlane) {
  EXPECT_TRUE(is_empty(region_of(nothing())));
  EXPECT_TRUE(is_whole(region_of(plane())));
  for (Kind kind : {Kind::kInterior, Kind::kClosure, Kind::kRegularize, Kind::kHull, Kind::kMirror}) {
    EXPECT_TRUE(is_empty(region_of(node(kind, {nothing()}))));
    EXPECT_TRUE(is_whole(region_of(node(kind, {plane()}))));
  }
  EXPECT_TRUE(is_empty(region_of(node(Kind::kBoundary, {plane()}))));
  EXPECT_TRUE(is_empty(region_of(offset_of(nothing(), 3))));
  EXPECT_TRUE(is_empty(region_of(offset_of(nothing(), -3))));
  EXPECT_TRUE(is_whole(region_of(offset_of(plane(), -3))));
  EXPECT_TRUE(is_empty(region_of(node(Kind::kMinkowskiSum, {nothing(), plane()}))));
  EXPECT_TRUE(is_whole(region_of(node(Kind::kMinkowskiDifference, {nothing(), nothing()}))));
  EXPECT_TRUE(is_empty(region_of(node(Kind::kMinkowskiDifference, {nothing(), box_of(0, 0, 1, 1)}))));
}

TEST(Build, SumsThatLeaveTheGridAreRefused) {
  const std::int64_t far = std::int64_t{1} << 40;
  ShapePtr sum = box_of(0, 0, far, far);
  for (int k = 0; k < 2; ++k) sum = node(Kind::kMinkowskiSum, {sum, sum});
  EXPECT_EQ(mark_at(region_of(sum), Real(4 * far), 0), 1);
  EXPECT_EQ(mark_at(region_of(sum), Real(4 * far + 1), 0), 0);
  ShapePtr deep = box_of(0, 0, 1000000000, 1000000000);
  for (int k = 0; k < 34; ++k) deep = node(Kind::kMinkowskiSum, {deep, deep});
  for (const ShapePtr& beyond : {node(Kind::kMinkowskiSum, {sum, sum}), offset_of(sum, 1), deep}) {
    try {
      region_of(beyond);
      ADD_FAILURE() << "it is made";
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kOutOfRange) << e.what();
    }
  }
}

TEST(Build, OneOperand) {
  ShapePtr box = box_of(0, 0, 3, 2);
  for (Kind kind : {Kind::kUnion, Kind::kIntersection, Kind::kDifference}) expect_same(node(kind, {box}), box);
}

TEST(Build, HullOfSeveral) {
  std::vector<ShapePtr> parts{box_of(0, 0, 1, 1), box_of(8, 0, 9, 1), box_of(3, 8, 5, 9)};
  expect_same(node(Kind::kHull, parts), node(Kind::kHull, {node(Kind::kUnion, parts)}));
  EXPECT_EQ(mark_at(region_of(node(Kind::kHull, parts)), 4, 5), 1);
}

TEST(Build, Primitives) {
  Shape rings;
  rings.kind = Kind::kRings;
  rings.contours =
      make_rings({contour_of({{0, 0}, {9, 0}, {9, 9}, {0, 9}}), contour_of({{3, 3}, {6, 3}, {6, 6}, {3, 6}})}, 1)
          .contours;
  Region holed = region_of(share(rings));
  EXPECT_EQ(mark_at(holed, 1, 1), 1);
  EXPECT_EQ(mark_at(holed, 3, 4), 1);
  EXPECT_EQ(mark_at(holed, 4, 4), 0);
  EXPECT_EQ(holed.faces.size(), 3u);
  Region disc = region_of(disc_of({1, 2}, sqrt(Real(2))));
  EXPECT_EQ(mark_at(disc, 2, 3), 1);
  EXPECT_EQ(disc.edges.size(), 2u);
  Region points = region_of(points_of({{1, 1}, {2, 2}, {1, 1}}));
  EXPECT_EQ(points.vertices.size(), 2u);
  Region chain = region_of(chain_of({{0, 0}, {4, 4}, {4, 0}, {0, 4}}));
  EXPECT_EQ(chain.vertices.size(), 5u);
  EXPECT_EQ(chain.edges.size(), 5u);
  EXPECT_EQ(chain.faces.size(), 2u);
  EXPECT_EQ(mark_at(chain, 3, 2), 0);
}

TEST(Build, DifferencesOfClosedSetsAreHalfOpen) {
  Region s = region_of(node(Kind::kDifference, {box_of(0, 0, 4, 4), box_of(2, 0, 4, 4)}));
  EXPECT_EQ(mark_at(s, 0, 2), 1);
  EXPECT_EQ(mark_at(s, 2, 2), 0);
  EXPECT_EQ(mark_at(s, 2, 0), 0);
  EXPECT_EQ(mark_at(s, 1, 0), 1);
  Region slit = region_of(node(Kind::kIntersection, {box_of(0, 0, 4, 4), box_of(4, 0, 8, 4)}));
  EXPECT_EQ(slit.edges.size(), 1u);
  EXPECT_EQ(slit.faces.size(), 1u);
}

TEST(Build, NestedBooleansAreOneOverlay) {
  ShapePtr a = box_of(0, 0, 6, 6), b = box_of(3, 3, 9, 9), c = disc_of({6, 3}, 2);
  ShapePtr tree =
      node(Kind::kDifference, {node(Kind::kUnion, {a, node(Kind::kIntersection, {b, node(Kind::kComplement, {c})})}),
                               node(Kind::kDifference, {c, a})});
  Region s = region_of(tree);
  for (int x = -2; x <= 20; ++x) {
    for (int y = -2; y <= 20; ++y) {
      auto in = [&](const ShapePtr& shape) {
        return mark_at(region_of(shape), Real::ratio(x, 2), Real::ratio(y, 2)) > 0;
      };
      bool expected = (in(a) || (in(b) && !in(c))) && !(in(c) && !in(a));
      EXPECT_EQ(mark_at(s, Real::ratio(x, 2), Real::ratio(y, 2)), expected) << x << " " << y;
    }
  }
}

TEST(Build, ManyOperands) {
  std::vector<ShapePtr> rows, all;
  for (int x = 0; x < 12; ++x) {
    std::vector<ShapePtr> row;
    for (int y = 0; y < 12; ++y) row.push_back(box_of(2 * x, 2 * y, 2 * x + 2, 2 * y + 2));
    all.insert(all.end(), row.begin(), row.end());
    rows.push_back(node(Kind::kUnion, row));
  }
  ShapePtr square = box_of(0, 0, 24, 24);
  expect_same(node(Kind::kUnion, all), square);
  expect_same(node(Kind::kUnion, rows), square);
  std::vector<ShapePtr> minus{square};
  minus.insert(minus.end(), all.begin() + 1, all.end());
  expect_same(
      node(Kind::kDifference, minus),
      node(Kind::kDifference, {box_of(0, 0, 2, 2), node(Kind::kUnion, {box_of(2, 0, 4, 4), box_of(0, 2, 2, 4)})}));
  std::vector<ShapePtr> without;
  for (const ShapePtr& cell : all) without.push_back(node(Kind::kComplement, {cell}));
  expect_same(node(Kind::kIntersection, without), node(Kind::kComplement, {square}));
}

TEST(Build, WhatLiesInAVoidOfOthersIsWithinThem) {
  std::vector<ShapePtr> boxes{box_of(0, 0, 3, 3), box_of(-3, 3, 0, 6), box_of(3, 3, 6, 6), box_of(0, 6, 3, 9),
                              box_of(1, 4, 2, 5)};
  for (const std::size_t far : {0u, 40u}) {
    for (std::size_t k = 0; k < far; ++k) {
      const auto x = std::int64_t(100 + 3 * k);
      boxes.push_back(box_of(x, 0, x + 1, 1));
    }
    const Region set = region_of(node(Kind::kUnion, boxes));
    EXPECT_EQ(set.faces[0].inner.size(), 1 + far);
  }
}

TEST(Build, SharedShapesAreBuiltOnce) {
  // 2^40 leaves as a tree, 41 shapes.
  ShapePtr shape = box_of(0, 0, 2, 2);
  for (int k = 0; k < 40; ++k) shape = node(Kind::kClosure, {node(Kind::kUnion, {shape, shape})});
  expect_same(shape, box_of(0, 0, 2, 2));
  for (int k = 0; k < 40; ++k) shape = node(Kind::kIntersection, {shape, shape});
  expect_same(shape, box_of(0, 0, 2, 2));
}

TEST(Build, RotationsReportWhatTheyRounded) {
  ShapePtr rotated = rotate_of(box_of(0, 0, 1000, 1000), {}, 30);
  BuildResult one = build(*node(Kind::kUnion, {rotated, translate_of(rotated, {5000, 0})}));
  EXPECT_EQ(one.rounding.points, 3);  // built once; the corner at the centre stays
  EXPECT_GT(one.rounding.largest, 0);
  EXPECT_LE(one.rounding.largest, 0.7072);
  EXPECT_EQ(build(*rotate_of(rotated, {}, 90)).rounding.points, 3);
  EXPECT_EQ(build(*rotate_of(box_of(0, 0, 1000, 1000), {3, 4}, 270)).rounding.points, 0);
}

TEST(Build, ErrorsNameTheShape) {
  Shape hull = *node(Kind::kHull, {node(Kind::kUnion, {disc_of({0, 0}, 1), disc_of({9, 0}, 2)})});
  hull.name = "belt";
  hull.place = "scene.json:7:3";
  try {
    build(*node(Kind::kComplement, {share(hull)}));
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kUnsupported);
    EXPECT_EQ(e.place(), "scene.json:7:3");
  }
}

TEST(Offset, SlitsPointsAndExactFits) {
  expect_same(offset_of(points_of({{3, 4}}), 2), disc_of({3, 4}, 2));
  expect_same(offset_of(disc_of({3, 4}, 2), -2), points_of({{3, 4}}));
  expect_same(offset_of(node(Kind::kInterior, {disc_of({3, 4}, 2)}), -2), nothing());
  expect_same(offset_of(box_of(0, 0, 10, 4), -2), chain_of({{2, 2}, {8, 2}}));
  expect_same(offset_of(box_of(0, 0, 10, 4), -3), nothing());
  expect_same(offset_of(box_of(0, 0, 10, 4), 0), box_of(0, 0, 10, 4));
  expect_same(offset_of(disc_of({0, 0}, 2), Real::ratio(3, 2)), disc_of({0, 0}, Real::ratio(7, 2)));
}

TEST(Offset, GrowingForgetsWhatIsOpen) {
  ShapePtr open = node(Kind::kInterior, {box_of(0, 0, 6, 6)});
  expect_same(offset_of(open, 2), offset_of(box_of(0, 0, 6, 6), 2));
}

TEST(Offset, ErosionOfAHalfOpenSquare) {
  // The lower side is missing: balls may touch the other three.
  ShapePtr set = node(Kind::kDifference, {box_of(0, 0, 6, 6), chain_of({{0, 0}, {6, 0}})});
  ShapePtr expected = node(Kind::kDifference, {box_of(2, 2, 4, 4), chain_of({{2, 2}, {4, 2}})});
  expect_same(offset_of(set, -2), expected);
  // One missing point of the side forbids one place only.
  ShapePtr punctured = node(Kind::kDifference, {box_of(0, 0, 6, 6), points_of({{3, 0}})});
  expect_same(offset_of(punctured, -2), node(Kind::kDifference, {box_of(2, 2, 4, 4), points_of({{3, 2}})}));
  // A puncture inside: all balls without it, which is an open ball less.
  ShapePtr inside = node(Kind::kDifference, {box_of(0, 0, 6, 6), points_of({{3, 3}})});
  expect_same(offset_of(inside, -1), node(Kind::kDifference, {box_of(1, 1, 5, 5), disc_of({3, 3}, 1)}));
}

TEST(MinkowskiNodes, HalfOpenOperands) {
  ShapePtr half = node(Kind::kDifference, {box_of(0, 0, 2, 2), chain_of({{0, 0}, {2, 0}})});
  expect_same(node(Kind::kMinkowskiSum, {half, half}),
              node(Kind::kDifference, {box_of(0, 0, 4, 4), chain_of({{0, 0}, {4, 0}})}));
  expect_same(node(Kind::kMinkowskiSum, {half, points_of({{5, 5}})}), translate_of(half, {5, 5}));
  expect_same(node(Kind::kMinkowskiDifference, {half, points_of({{5, 5}})}), translate_of(half, {5, 5}));
  expect_same(node(Kind::kMinkowskiDifference, {box_of(0, 0, 4, 4), half}), box_of(2, 2, 4, 4));
  ShapePtr open_segment = node(Kind::kDifference, {chain_of({{0, 0}, {3, 0}}), points_of({{0, 0}, {3, 0}})});
  ShapePtr half_segment = node(Kind::kDifference, {chain_of({{0, 0}, {0, 3}}), points_of({{0, 0}})});
  expect_same(
      node(Kind::kMinkowskiSum, {open_segment, half_segment}),
      node(Kind::kDifference, {box_of(0, 0, 3, 3), node(Kind::kUnion, {chain_of({{0, 3}, {0, 0}, {3, 0}, {3, 3}})})}));
}

}  // namespace plane_build
}  // namespace findspace::plane
