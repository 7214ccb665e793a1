// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shape trees as sets of boxes and as convex parts, and their bounds: against the definition, pieces without interior,
// and sizes at which memory and time count.
#include <findspace/error.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "space/body/csg_solid.h"
#include "space/shape/box_shape.h"
#include "space/shape/shape_rays.h"
#include "unit/solid_shapes.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_shape_trees {

using exact::Real;
using plane::ShapePtr;
using Kind = plane::Shape::Kind;

ShapePtr block(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return hull(std::move(corners));
}

/// Twice the coordinates of a place, in a block or not.
bool in(const std::array<std::int64_t, 3>& p, std::int64_t low, std::int64_t high) {
  return std::all_of(p.begin(), p.end(), [&](std::int64_t c) { return 2 * low <= c && c <= 2 * high; });
}

TEST(BoxShapes, AreMadeAsTheirNodesSay) {
  const ShapePtr a = block({0, 0, 0}, {4, 4, 4}), b = block({2, 2, 2}, {6, 6, 6}), c = block({3, 3, 3}, {5, 5, 5});
  const auto outside = [](const ShapePtr& of) { return node(Kind::kComplement, {of}); };
  const auto all = box_complex(*node(Kind::kUnion, {a, outside(b), c})),
             some = box_complex(*node(Kind::kIntersection, {a, outside(c), b})),
             rest = box_complex(*node(Kind::kDifference, {outside(a), b, c})),
             hull_of_none = box_complex(*node(Kind::kHull, {node(Kind::kDifference, {c, b})}));
  ASSERT_TRUE(all && some && rest && hull_of_none);
  EXPECT_TRUE(hull_of_none->empty());
  for (std::int64_t x = -2; x <= 14; ++x) {
    for (std::int64_t y = -2; y <= 14; ++y) {
      for (std::int64_t z = -2; z <= 14; ++z) {
        const std::array<std::int64_t, 3> p{x, y, z};
        const bool in_a = in(p, 0, 4), in_b = in(p, 2, 6), in_c = in(p, 3, 5);
        const RealVector at = place(x, y, z, 2);
        ASSERT_EQ(all->mark(at) != 0, in_a || !in_b || in_c) << x << " " << y << " " << z;
        ASSERT_EQ(some->mark(at) != 0, in_a && !in_c && in_b) << x << " " << y << " " << z;
        ASSERT_EQ(rest->mark(at) != 0, !in_a && !in_b && !in_c) << x << " " << y << " " << z;
      }
    }
  }
}

ShapePtr shrunk(ShapePtr of) {
  plane::Shape shape;
  shape.kind = Kind::kOffset;
  shape.children = {std::move(of)};
  shape.amount = Real(-1);
  return std::make_shared<const plane::Shape>(std::move(shape));
}

TEST(BoxShapes, KeepTheirOpenEndsInHullsAndWhereTheyShrink) {
  const ShapePtr box = block({0, 0, 0}, {8, 8, 8}), part = block({2, 0, 0}, {9, 9, 9});
  const ShapePtr open = node(Kind::kInterior, {box}), half = node(Kind::kDifference, {box, part});
  const ShapePtr frame = node(Kind::kDifference, {open, block({3, 3, -1}, {5, 5, 9})});
  const auto of_open = box_complex(*shrunk(open)), of_half = box_complex(*shrunk(half)),
             hull = box_complex(*node(Kind::kHull, {frame}));
  ASSERT_TRUE(of_open && of_half && hull);
  EXPECT_EQ(of_open->mark(place(1, 4, 4)), 0);
  EXPECT_EQ(of_open->mark(place(3, 4, 4, 2)), 1);
  EXPECT_TRUE(of_half->empty());  // [0, 2) is as wide as the ball, which is closed
  EXPECT_EQ(hull->mark(place(0, 4, 4)), 0);
  EXPECT_EQ(hull->mark(place(4, 4, 1)), 1);
  const ShapePtr sheet = node(Kind::kIntersection, {block({3, 3, 0}, {5, 5, 4}), block({3, 3, 4}, {5, 5, 8})});
  const ShapePtr slit = node(Kind::kDifference, {box, sheet}), outside = node(Kind::kComplement, {sheet});
  EXPECT_FALSE(box_complex(*shrunk(slit)));  // round about the sheet
  EXPECT_FALSE(box_complex(*shrunk(outside)));
}

/// Fourteen million cells, once for each of the sixty blocks, would be 840 MB.
TEST(BoxShapes, AUnionOfManyTakesOneGrid) {
  std::vector<ShapePtr> blocks;
  for (std::int64_t k = 0; k < 60; ++k)
    blocks.push_back(block({3 * k, 3 * k, 3 * k}, {3 * k + 1, 3 * k + 1, 3 * k + 1}));
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  const auto all = box_complex(*node(Kind::kUnion, blocks));
  getrusage(RUSAGE_SELF, &after);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->at()[0].size(), 120u);
  EXPECT_EQ(all->mark(place(31, 31, 31)), 1);
  EXPECT_EQ(all->mark(place(31, 31, 32)), 0);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 300'000);  // kilobytes
}

/// A minute where each column of the grid looks at all edges.
TEST(BoxShapes, APlateWithManyHoles) {
  constexpr std::int64_t kHoles = 200, kSide = 3 * kHoles + 1;
  Solid plate;
  plate.form = Solid::Form::kPrism;
  plate.high = 2;
  const auto add = [&](std::int64_t x, std::int64_t y, std::int64_t side) {
    plate.contours.push_back(
        {{.start = {x, y}}, {.start = {x + side, y}}, {.start = {x + side, y + side}}, {.start = {x, y + side}}});
  };
  add(0, 0, kSide);
  for (std::int64_t i = 0; i < kHoles; ++i) {
    for (std::int64_t j = 0; j < kHoles; ++j) add(3 * i + 1, 3 * j + 1, 2);
  }
  const auto start = std::chrono::steady_clock::now();
  const auto set = box_complex(*primitive(std::move(plate)));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_TRUE(set);
  EXPECT_EQ(set->mark(place(302, 302, 1)), 0);
  EXPECT_EQ(set->mark(place(301, 301, 1, 2)), 1);
  EXPECT_LT(seconds, 20);  // less than one where it was written; room for sanitizers
}

/// Without the open set T keeps the facet that lies on the boundary of P.
TEST(ConvexParts, OfAShapeLessAnIntersectionOfInteriors) {
  const ShapePtr t = hull({{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}),
                 p = hull({{-10, -10, 0}, {18, -10, 0}, {-10, 18, 0}, {-10, -10, 28}}),
                 q = hull({{-20, -20, -20}, {100, -20, -20}, {-20, 100, -20}, {-20, -20, 100}});
  const ShapePtr open = node(Kind::kIntersection, {node(Kind::kInterior, {p}), node(Kind::kInterior, {q})});
  EXPECT_TRUE(try_convex_parts(*node(Kind::kDifference, {t, node(Kind::kIntersection, {p, q})})));
  EXPECT_FALSE(try_convex_parts(*node(Kind::kDifference, {t, open})));
  const ShapePtr apart = node(Kind::kTranslate, {open}, {0, 0, -1});
  EXPECT_TRUE(try_convex_parts(*node(Kind::kDifference, {t, apart})));
}

const ShapePtr kLow = hull({{0, 0, 0}, {4, 0, 0}, {5, 3, 0}, {0, 3, 0}, {0, 0, 2}, {4, 0, 2}, {5, 3, 2}, {0, 3, 2}}),
               kHigh = node(Kind::kTranslate, {kLow}, {0, 0, 2}),
               kBlock = hull({{-5, -5, -5}, {9, -5, -5}, {-5, 9, -5}, {9, 10, -5}, {-5, -5, 9}, {9, 9, 9}});

ShapePtr open_pair(std::int64_t gap) {
  const ShapePtr high = node(Kind::kTranslate, {node(Kind::kInterior, {kHigh})}, {0, 0, gap});
  return node(Kind::kUnion, {node(Kind::kInterior, {kLow}), high});
}

/// The wall between the open sets stays, and has no interior.
TEST(ConvexParts, RefuseAWallThatIsTakenAwayByNone) {
  const auto moved = [](ShapePtr s) {
    return node(Kind::kMirror, {node(Kind::kTranslate, {std::move(s)}, {1, 1, 1})});
  };
  const auto less = [](const ShapePtr& s) { return bool(try_convex_parts(*node(Kind::kDifference, {kBlock, s}))); };
  EXPECT_FALSE(less(open_pair(0)));
  EXPECT_FALSE(less(moved(open_pair(0))));
  EXPECT_FALSE(less(node(Kind::kInterior, {open_pair(0)})));
  EXPECT_TRUE(less(moved(open_pair(1))));
  EXPECT_TRUE(less(node(Kind::kClosure, {open_pair(0)})));
  const ShapePtr cube = block({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(try_convex_parts(*node(Kind::kMinkowskiDifference, {open_pair(0), cube})));
  EXPECT_TRUE(try_convex_parts(*node(Kind::kMinkowskiDifference, {open_pair(1), cube})));
  EXPECT_FALSE(try_body(*shrunk(open_pair(0))));
  EXPECT_FALSE(try_body(*node(Kind::kComplement, {node(Kind::kUnion, {open_pair(0), ball({0, 0, 0}, 1)})})));
  EXPECT_FALSE(try_csg_solid(*node(Kind::kDifference, {ball({2, 2, 2}, 9), open_pair(0)})));
  EXPECT_TRUE(try_csg_solid(*node(Kind::kDifference, {ball({2, 2, 2}, 9), open_pair(1)})));
}

/// b without c lacks the boundary of c: what a has in common with c stays.
TEST(ConvexParts, OfAShapeLessADifference) {
  const auto left = [](const ShapePtr& b, const ShapePtr& c) {
    return try_convex_parts(*node(Kind::kDifference, {kLow, node(Kind::kDifference, {b, c})}));
  };
  EXPECT_FALSE(left(kBlock, kHigh));  // a face without interior
  const auto all = left(kBlock, kBlock);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->parts.size(), 1u);
  EXPECT_TRUE(left(kHigh, node(Kind::kTranslate, {kHigh}, {1, 0, 0})));  // stands on a face that stays as a whole
}

TEST(ShapeRays, TakeSumsAndHullsOfOpenSetsAsOpen) {
  const ShapePtr open = node(Kind::kInterior, {kLow});
  const RayGrid line{.axis = 2, .u = 1, .v = 1, .nu = 1, .nv = 1};
  for (const ShapePtr& set :
       {node(Kind::kHull, {open}), node(Kind::kMinkowskiSum, {open, block({-1, -1, 0}, {0, 0, 1})})}) {
    const RaySourcePointer rays = shape_rays(*set, line);
    const RayRow row = rays->row(0);
    EXPECT_EQ(sign_at(row, 0, Real()), 1);
    EXPECT_LE(sign_at(row, 0, Real(1)), 0);
  }
  const ShapePtr half = node(Kind::kDifference, {kLow, kHigh});  // taken as closed
  EXPECT_LE(sign_at(shape_rays(*node(Kind::kHull, {half}), line)->row(0), 0, Real()), 0);
}

TEST(ShapeBox, ABoundaryIsBounded) {
  const ShapePtr outside = node(Kind::kComplement, {block({1, 2, 3}, {4, 5, 6})});
  EXPECT_TRUE(shape_box(*outside).unbounded);
  const ShapeBox box = shape_box(*node(Kind::kBoundary, {outside}));
  EXPECT_FALSE(box.unbounded);
  EXPECT_EQ(box.low, (Point{1, 2, 3}));
  EXPECT_EQ(box.high, (Point{4, 5, 6}));
}

}  // namespace space_shape_trees
}  // namespace findspace::space
