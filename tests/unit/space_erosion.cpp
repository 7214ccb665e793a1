// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "space/body/cell_parts.h"
#include "space/body/csg_solid.h"
#include "space/body/erosion.h"
#include "unit/solid_shapes.h"

namespace findspace::space {
namespace space_erosion {

using exact::Real;
using plane::Shape;
using plane::ShapePtr;
using Kind = Shape::Kind;

ShapePtr offset(ShapePtr of, const Real& by) {
  Shape shape;
  shape.kind = Kind::kOffset;
  shape.children = {std::move(of)};
  shape.amount = by;
  return std::make_shared<const Shape>(std::move(shape));
}

ShapePtr block(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return hull(std::move(corners));
}

Real six_volumes(const Body& body) {
  Real sum;
  for (const BodyPart& part : body.parts) sum = sum + space::six_volumes(*part.core);
  const Real s(body.scale);
  return sum / (s * s * s);
}

const ShapePtr kTetrahedron = hull({{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}});

TEST(Erosion, TakesTheRadiusFirstAndThenMovesTheFaces) {
  const ShapePtr rounded = offset(block({-5, -5, -5}, {5, 5, 5}), Real(3));
  for (const int by : {1, 3, 5}) {
    const Body body = space::body(*offset(rounded, Real(-by)));
    ASSERT_EQ(body.parts.size(), 1u);
    EXPECT_EQ(body.parts[0].radius, Real(std::max(3 - by, 0)));
    EXPECT_EQ(bounds(body).high[0], Real(8 - by));
    EXPECT_EQ(body.rounded, 0);
  }
  EXPECT_THROW(body(*offset(rounded, Real(-8))), Error);
}

TEST(Erosion, LeavesTheCentreOfABallAndNothingOfACapsule) {
  const Body point = body(*offset(ball({1, 2, 3}, 4), Real(-4)));
  EXPECT_TRUE(point.parts[0].point());
  EXPECT_EQ(point.parts[0].radius, Real());
  EXPECT_EQ(bounds(point).low[1], Real(2));
  EXPECT_THROW(body(*offset(ball({1, 2, 3}, 4), Real(-5))), Error);
  const ShapePtr capsule = node(Kind::kHull, {ball({0, 0, 0}, 4), ball({9, 0, 0}, 4)});
  EXPECT_EQ(body(*offset(capsule, Real(-3))).parts[0].radius, Real(1));
  try {
    body(*offset(capsule, Real(-4)));
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kGeometry);
  }
}

TEST(Erosion, PutsCornersOnTheGridOnceAndCountsThem) {
  const Body shrunk = body(*offset(kTetrahedron, Real(-1)));
  EXPECT_EQ(shrunk.parts[0].vertices().size(), 4u);
  EXPECT_EQ(shrunk.rounded, 3);  // (1, 1, 1) is on the grid
  EXPECT_GT(shrunk.moved, 0);
  EXPECT_LT(shrunk.moved, 1);
  const Body exactly = body(*node(Kind::kMinkowskiDifference, {kTetrahedron, block({0, 0, 0}, {1, 1, 1})}));
  EXPECT_EQ(exactly.rounded, 0);
  EXPECT_EQ(six_volumes(exactly), Real(9 * 9 * 9));  // its corner at (1, 1, 1), as large as x + y + z <= 12 allows
}

TEST(Erosion, OfAComplementIsTheComplementOfTheSum) {
  const Body larger = body(*offset(node(Kind::kComplement, {ball({0, 0, 0}, 2)}), Real(-1)));
  EXPECT_TRUE(larger.outside);
  EXPECT_EQ(larger.parts[0].radius, Real(3));
  const Body smaller = body(*offset(node(Kind::kComplement, {block({0, 0, 0}, {9, 9, 9})}), Real(2)));
  EXPECT_TRUE(smaller.outside);
  EXPECT_EQ(bounds(smaller).high[2], Real(7));
}

TEST(Erosion, OfAnLByABoxIsALAgain) {
  const ShapePtr both = node(Kind::kUnion, {block({0, 0, 0}, {12, 4, 5}), block({0, 0, 0}, {4, 12, 5})});
  const Body left = body(*node(Kind::kMinkowskiDifference, {both, block({0, 0, 0}, {2, 2, 2})}));
  EXPECT_EQ(six_volumes(left), Real(6 * 3 * (10 * 2 + 2 * 8)));
  EXPECT_THROW(body(*offset(both, Real(-1))), Error);  // round at the inner edge
  const CsgSolid round = csg_solid(*offset(both, Real(-1)));
  EXPECT_EQ(round.containers.size(), 1u);
  ASSERT_EQ(round.obstacles.size(), 1u);
  EXPECT_EQ(round.obstacles[0].parts[0].radius, Real(round.obstacles[0].scale));
}

TEST(Erosion, OfABowlMovesItsWallsAndItsHollow) {
  const ShapePtr bowl = node(Kind::kDifference, {block({-20, -20, -20}, {20, 20, 20}), ball({0, 0, 20}, 15)});
  const CsgSolid shrunk = csg_solid(*offset(bowl, Real(-1)));
  ASSERT_EQ(shrunk.parts.size(), 1u);
  EXPECT_EQ(bounds(shrunk).high[0], Real(19));
  ASSERT_EQ(shrunk.parts[0].without.size(), 1u);
  EXPECT_EQ(shrunk.parts[0].without[0].radius, Real(16));
}

TEST(Erosion, OfAUnionThatFillsItsBoxHasNothingToKeepOut) {
  const ShapePtr both = node(Kind::kUnion, {block({0, 0, 0}, {10, 10, 10}), block({10, 0, 0}, {20, 10, 10})});
  const CsgSolid shrunk = csg_solid(*offset(node(Kind::kDifference, {both, ball({10, 5, 10}, 3)}), Real(-1)));
  EXPECT_EQ(shrunk.containers.size(), 1u);
  ASSERT_EQ(shrunk.obstacles.size(), 1u);  // the ball
  EXPECT_EQ(shrunk.obstacles[0].parts[0].radius, Real(4));
}

TEST(Erosion, RefusesComplementsThatAreTakenAwayOrShrinkOthers) {
  const ShapePtr outside = node(Kind::kComplement, {block({-5, -5, -5}, {5, 5, 5})});
  const ShapePtr lens = node(Kind::kDifference, {ball({0, 0, 0}, 9), outside}),
                 bowl = node(Kind::kDifference, {block({-20, -20, -20}, {20, 20, 20}), ball({0, 0, 20}, 15)});
  EXPECT_FALSE(try_csg_solid(*offset(lens, Real(-1))));
  EXPECT_FALSE(try_csg_solid(*offset(node(Kind::kMinkowskiDifference, {bowl, outside}), Real(-1))));
  EXPECT_FALSE(try_csg_solid(*node(Kind::kMinkowskiDifference, {offset(bowl, Real(-1)), outside})));
}

TEST(Erosion, KeepsSheetsThatDistancesDoNotSee) {
  const ShapePtr thin = node(Kind::kIntersection, {block({0, 0, 0}, {4, 9, 9}), block({2, 0, 0}, {9, 9, 9})});
  const auto plain = cut_erosion(*node(Kind::kMinkowskiDifference, {thin, block({0, 0, 0}, {2, 2, 2})}));
  ASSERT_TRUE(plain);
  ASSERT_EQ(plain->parts.size(), 1u);
  EXPECT_EQ(bounds(plain->parts[0]).low[0], Real(4));
  EXPECT_EQ(bounds(plain->parts[0]).high[0], Real(4));
  const ShapePtr round = offset(node(Kind::kIntersection, {thin, ball({3, 4, 4}, 20)}), Real(-1));
  const auto sheet = cut_erosion(*round);
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->parts.size(), 1u);
  EXPECT_TRUE(csg_solid(*round).parts.empty());
}

ShapePtr prism(const std::vector<plane::GridPoint>& polygon, std::int64_t high) {
  Solid solid;
  solid.form = Solid::Form::kPrism;
  solid.high = high;
  plane::Contour& ring = solid.contours.emplace_back();
  for (const plane::GridPoint& p : polygon) ring.push_back({p});
  return primitive(std::move(solid));
}

/// A room with an aisle as wide as the cube: the sheet in its middle is part of what is left.
TEST(Erosion, RefusesASlotOfNoWidth) {
  const auto left = [](std::int64_t wide, bool round) {
    const ShapePtr room =
        prism({{0, 0}, {10, 0}, {10, 4}, {20, 4}, {20, 4 + wide}, {10, 4 + wide}, {10, 10}, {0, 12}}, 10);
    const ShapePtr holed = round ? node(Kind::kDifference, {room, ball({0, 0, 0}, 2)}) : room;
    return try_csg_solid(*node(Kind::kMinkowskiDifference, {holed, block({-1, -1, -1}, {1, 1, 1})}));
  };
  for (const bool round : {false, true}) {
    EXPECT_TRUE(left(1, round));
    EXPECT_FALSE(left(2, round));
    EXPECT_TRUE(left(3, round));
  }
}

const ShapePtr kCube = block({-1, -1, -1}, {1, 1, 1});

/// Along a face of the room.
TEST(Erosion, RefusesASlotOfNoWidthBesideAFace) {
  const auto left = [](std::int64_t wide, bool round) {
    const ShapePtr room = prism({{0, 0}, {20, 0}, {20, wide}, {10, wide}, {10, 10}, {0, 12}}, 10);
    const ShapePtr holed = round ? node(Kind::kDifference, {room, ball({0, 0, 0}, 2)}) : room;
    return try_csg_solid(*node(Kind::kMinkowskiDifference, {holed, kCube}));
  };
  for (const bool round : {false, true}) {
    EXPECT_TRUE(left(1, round));
    EXPECT_FALSE(left(2, round));
    EXPECT_TRUE(left(3, round));
  }
}

/// A ball that takes all of the slot away leaves none; one that takes a part leaves the rest.
TEST(Erosion, OfASlotThatABallTakesAway) {
  const ShapePtr room = prism({{0, 0}, {10, 0}, {10, 4}, {20, 4}, {20, 6}, {10, 6}, {10, 10}, {0, 12}}, 10);
  const auto left = [&](const Point& center) {
    const ShapePtr holed = node(Kind::kDifference, {room, ball(center, 12)});
    return try_csg_solid(*node(Kind::kMinkowskiDifference, {holed, kCube}));
  };
  const auto taken = left({20, 5, 5});
  ASSERT_TRUE(taken);
  EXPECT_EQ(bounds(*taken).high[0], Real(9) * Real(taken->scale));
  EXPECT_FALSE(left({25, 5, 5}));
  const ShapePtr within = node(Kind::kIntersection, {room, ball({0, 5, 5}, 9)});  // does not reach the slot
  EXPECT_TRUE(try_csg_solid(*node(Kind::kMinkowskiDifference, {within, kCube})));
}

/// A pocket is taken away with its floor: what is below it, as thick as the cube, is gone.
TEST(Erosion, OfAWallBesideAPocketLeavesNoSheet) {
  const ShapePtr plate = prism({{0, 0}, {20, 0}, {24, 10}, {20, 20}, {0, 20}, {-4, 10}}, 4);
  const ShapePtr pocket = node(Kind::kTranslate, {prism({{5, 5}, {15, 5}, {15, 15}, {6, 15}}, 4)}, {0, 0, 2});
  const ShapePtr part = node(Kind::kDifference, {plate, pocket});
  EXPECT_TRUE(try_csg_solid(*node(Kind::kMinkowskiDifference, {part, kCube})));
  EXPECT_TRUE(try_csg_solid(*offset(part, Real(-1))));
  const ShapePtr whole = node(Kind::kClosure, {part});
  EXPECT_FALSE(try_csg_solid(*node(Kind::kMinkowskiDifference, {whole, kCube})));
}

/// The plate is less than a step thick then.
TEST(Erosion, KeepsWhatIsThinnerThanAStep) {
  const ShapePtr plate = prism({{0, 0}, {100, 0}, {103, 20}, {3, 20}}, 100);
  const Real by = -Real::ratio(98, 10);
  const Body thin = body(*offset(plate, by));
  ASSERT_EQ(thin.parts.size(), 1u);
  EXPECT_EQ(bounds(thin).high[1], Real::ratio(102, 10) * Real(thin.scale));
  EXPECT_GT(thin.rounded, 0);
  EXPECT_LT(thin.moved, 0.001);
  const Body both = body(*node(Kind::kUnion, {offset(plate, by), ball({200, 0, 0}, 10)}));
  EXPECT_EQ(both.parts.size(), 2u);
  const ShapePtr holed = node(Kind::kDifference, {plate, ball({50, 20, 50}, 5)});
  EXPECT_EQ(csg_solid(*offset(holed, by)).parts.size(), 1u);
}

/// The hull of a drilled part has all its corners, and with them its faces.
TEST(ConvexParts, OfAShapeLessAHull) {
  const ShapePtr column = prism({{0, 0}, {10, 0}, {12, 5}, {10, 10}, {0, 10}, {-2, 5}}, 30),
                 low = prism({{0, 0}, {10, 0}, {12, 5}, {10, 10}, {0, 10}, {-2, 5}}, 5);
  const auto left = [&](const ShapePtr& hole) {
    const ShapePtr drilled = node(Kind::kDifference, {low, hole});
    return try_convex_parts(*node(Kind::kDifference, {column, node(Kind::kHull, {drilled})}));
  };
  const auto above = left(prism({{3, 3}, {6, 3}, {7, 5}, {6, 7}, {3, 7}}, 20));
  ASSERT_TRUE(above);
  EXPECT_EQ(above->parts.size(), 1u);
  EXPECT_FALSE(left(prism({{8, -1}, {13, -1}, {13, 3}, {8, 4}}, 20)));  // takes a corner
}

TEST(ConvexParts, OfAnIntersectionWithAComplement) {
  const ShapePtr column = prism({{0, 0}, {10, 0}, {12, 5}, {10, 10}, {0, 10}}, 9);
  const ShapePtr low = node(Kind::kComplement, {block({-5, -5, -5}, {20, 20, 4})});
  const auto both = try_convex_parts(*node(Kind::kIntersection, {low, column}));
  ASSERT_TRUE(both);
  ASSERT_EQ(both->parts.size(), 1u);
  EXPECT_EQ(space::six_volumes(both->parts[0]), Real(6 * 5 * 110));
  EXPECT_FALSE(try_convex_parts(*node(Kind::kIntersection, {low, low})));
}

/// What a drilled part lacks leaves nothing thin where another part, or it itself, is in its place.
TEST(ConvexParts, OfAShapeLessWhatIsMadeOfADrilledPart) {
  const ShapePtr plate = prism({{0, 0}, {20, 0}, {24, 10}, {20, 20}, {0, 20}, {-4, 10}}, 8);
  const ShapePtr hole = prism({{6, 8}, {8, 6}, {12, 6}, {14, 8}, {14, 12}, {12, 14}, {8, 14}, {6, 12}}, 10);
  const ShapePtr drilled = node(Kind::kDifference, {plate, node(Kind::kTranslate, {hole}, {0, 0, -1})});
  const auto left = [](const ShapePtr& from, const ShapePtr& away) {
    return try_convex_parts(*node(Kind::kDifference, {from, away}));
  };
  const ShapePtr around = block({-30, -30, -30}, {50, 50, 50});
  EXPECT_TRUE(left(around, node(Kind::kMinkowskiSum, {drilled, kCube})));  // walls of the sum are within others
  EXPECT_TRUE(left(plate, node(Kind::kMinkowskiDifference, {drilled, block({0, 0, 0}, {1, 1, 1})})));
  const auto step = left(drilled, node(Kind::kTranslate, {drilled}, {0, 0, 4}));
  ASSERT_TRUE(step);  // the wall of the hole is in neither
  Real six;
  for (const Polytope& part : step->parts) six += space::six_volumes(part);
  const Real scale(step->scale);
  EXPECT_EQ(six, Real(6 * 4 * (480 - 56)) * scale * scale * scale);
}

/// Each cut lies on a grid of its own, and both have none in common.
TEST(ConvexParts, AreRoundedAndCountedWithoutACommonGrid) {
  constexpr std::int64_t kUnit = 1000000;
  const ShapePtr above = prism({{0, 0}, {10 * kUnit, 3700000}, {10 * kUnit, 10 * kUnit}, {0, 10 * kUnit}}, kUnit);
  const auto cut = [&](std::int64_t y) {
    const ShapePtr below = prism({{0, 5 * kUnit}, {0, -3 * kUnit}, {10 * kUnit, -3 * kUnit}, {10 * kUnit, y}}, kUnit);
    return node(Kind::kIntersection, {above, below});
  };
  EXPECT_EQ(convex_parts(*cut(2027000)).rounded, 0);
  const ConvexParts both = convex_parts(*node(Kind::kUnion, {cut(2027000), cut(2021000)}));
  EXPECT_EQ(both.parts.size(), 2u);
  EXPECT_GT(both.rounded, 0);
  EXPECT_GT(both.moved, 0);
  EXPECT_LT(both.moved, 1);
}

TEST(CsgSolid, RefusesAFaceInCommon) {
  const ShapePtr low = hull({{0, 0, 6}, {3, 0, 6}, {0, 3, 6}, {0, 0, 3}}),
                 high = hull({{0, 0, 6}, {3, 0, 6}, {0, 3, 6}, {0, 0, 9}});
  const ShapePtr round = ball({0, 0, 0}, 2), whole = block({-4, -3, -3}, {-1, 3, 3});
  const auto both = [](const ShapePtr& a, const ShapePtr& b) {
    return try_csg_solid(*node(Kind::kIntersection, {a, b}));
  };
  EXPECT_FALSE(both(node(Kind::kUnion, {round, high}), node(Kind::kUnion, {whole, low})));
  const auto held = both(node(Kind::kUnion, {round, high, low}), node(Kind::kUnion, {whole, low}));
  ASSERT_TRUE(held);
  EXPECT_EQ(held->parts.size(), 2u);
}

/// What the round solid has in common with the set that is put back is a sheet.
TEST(CsgSolid, RefusesTheSkinOfASetThatIsPutBack) {
  const ShapePtr low = prism({{0, 0}, {4, 0}, {5, 3}, {0, 3}}, 2), all = block({-9, -9, -9}, {19, 19, 19});
  const ShapePtr dome = node(Kind::kIntersection, {low, ball({2, 1, 1}, 2)});
  const auto left = [&](std::int64_t up) {
    const ShapePtr back = node(Kind::kTranslate, {low}, {0, 0, up});
    return try_csg_solid(*node(Kind::kDifference, {dome, node(Kind::kDifference, {all, back})}));
  };
  EXPECT_FALSE(left(2));
  EXPECT_TRUE(left(1));
}

TEST(CsgSolid, CountsRoundedVertices) {
  const ShapePtr roof = hull({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 7}});
  const CsgSolid left = csg_solid(*offset(node(Kind::kDifference, {roof, ball({0, 0, 0}, 2)}), -Real::ratio(1, 10)));
  EXPECT_GT(left.rounded, 0);
  EXPECT_GT(left.moved, 0);
}

TEST(Erosion, OfRoundShapesByPolytopesIsWhatTheirCopiesHaveInCommon) {
  const CsgSolid lens =
      csg_solid(*node(Kind::kMinkowskiDifference, {ball({0, 0, 0}, 10), block({0, 0, 0}, {2, 2, 2})}));
  ASSERT_EQ(lens.parts.size(), 1u);
  EXPECT_EQ(lens.parts[0].within.size(), 8u);
  EXPECT_EQ(bounds(lens).low[0], Real(-8));
  EXPECT_EQ(bounds(lens).high[0], Real(10));
}

}  // namespace space_erosion
}  // namespace findspace::space
