// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A bowl, which has no convex parts: what a world says of it, at positions and on lines.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cmath>

#include "formula/solid/solve_rays.h"
#include "formula/solid/solve_space.h"
#include "unit/solid_shapes.h"
#include "unit/space_bodies.h"

namespace findspace::formula {
namespace formula_cut_solid {

using exact::Real;
using Kind = plane::Shape::Kind;

plane::ShapePtr block(const space::Point& low, const space::Point& high) {
  std::vector<space::Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return space::hull(std::move(corners));
}

plane::ShapePtr cube(std::int64_t half) { return block({-half, -half, -half}, {half, half, half}); }

plane::ShapePtr bowl() { return space::node(Kind::kDifference, {cube(20), space::ball({0, 0, 20}, 15)}); }

Distance named(findspace::formula::Kind kind, bool rotated = false) {
  Distance d;
  d.kind = kind;
  d.first = {rotated ? "A" : "B"};
  d.second = {rotated ? "B" : "A"};
  return d;
}

SpaceWorld world(const char* moving) {
  SpaceWorld out;
  out.shapes["A"] = space_shape(*bowl());
  out.shapes["B"] = space_shape(*cube(3));
  out.moving = {moving};
  out.step = Real(1);
  return out;
}

TEST(CutSolid, HasValuesWhicheverShapeMoves) {
  using K = findspace::formula::Kind;
  const SpaceSolver solver(world("B")), back(world("A"));
  const auto p = space::place(0, 0, 17), q = space::place(0, 0, -17);
  EXPECT_EQ(solver.value(named(K::kGamma1), p)->value, Real(15) - sqrt(Real(54)));
  EXPECT_EQ(back.value(named(K::kGamma1, true), q)->value, Real(15) - sqrt(Real(54)));
  EXPECT_EQ(back.value(named(K::kEta1), q)->value, solver.value(named(K::kEta1), p)->value);
  EXPECT_EQ(solver.value(named(K::kEta1), space::place(0, 0, -10))->value, Real(-7));
  EXPECT_FALSE(solver.value(named(K::kDelta1), p));
  EXPECT_EQ(solver.value(named(K::kGamma1), space::place(0, 0, -12))->value, Real(-11));
  EXPECT_EQ(back.value(named(K::kPenetration, true), space::place(0, 0, 12))->value, Real(11));
  EXPECT_EQ(solver.value(named(K::kD1), space::place(0, 0, 3))->value, Real());
}

TEST(CutSolid, HasLeastValuesAndADiameter) {
  using K = findspace::formula::Kind;
  for (const char* moving : {"B", "A"}) {
    const SpaceSolver solver(world(moving));
    const bool back = std::string(moving) == "A";
    const auto least = solver.nearly_least(named(K::kGamma2, back));
    ASSERT_TRUE(least);
    EXPECT_NEAR(least->value.to_double(), 23 * std::sqrt(3.0), 1e-8);
    EXPECT_LE(least->bounds().lower->to_double(), 23 * std::sqrt(3.0));
    EXPECT_EQ(solver.nearly_least(named(K::kD1, back))->value, Real());
    EXPECT_EQ(solver.value(named(K::kDiameter, back), space::place(0, 0, 0))->value, sqrt(Real(4800)));
  }
}

/// All places of a sphere are as near to its centre, and as far.
TEST(CutSolid, HasExactValuesAboutTheCentreOfAShell) {
  using K = findspace::formula::Kind;
  SpaceWorld all = world("B");
  all.shapes["A"] =
      space_shape(*space::node(Kind::kDifference, {space::ball({0, 0, 0}, 10), space::ball({0, 0, 0}, 6)}));
  all.shapes["B"] = space_shape(*space::ball({0, 0, 0}, 2));
  const SpaceSolver solver(all);
  const auto near = solver.value(named(K::kGamma1), space::place(0, 0, 0)),
             far = solver.value(named(K::kGamma2), space::place(0, 0, 0));
  ASSERT_TRUE(near && far);
  EXPECT_TRUE(near->proven);
  EXPECT_TRUE(far->proven);
  EXPECT_EQ(near->value, Real(4));
  EXPECT_EQ(far->value, Real(12));
}

/// B where it is drawn, and A.
std::optional<distance::Answer> drawn(findspace::formula::Kind kind, const plane::ShapePtr& b,
                                      const plane::ShapePtr& a) {
  SpaceWorld all = world("B");
  all.shapes["A"] = space_shape(*a);
  all.shapes["B"] = space_shape(*b);
  return SpaceSolver(all).value(named(kind), space::place(0, 0, 0));
}

/// Bodies within one of them and about it tell the ends.
TEST(CutSolid, HasValuesBesideAnotherOneOrInAComplementBetweenEnds) {
  using K = findspace::formula::Kind;
  const auto holds = [](const std::optional<distance::Answer>& v, const Real& truth, double width) {
    ASSERT_TRUE(v);
    const distance::Enclosure ends = v->bounds();
    ASSERT_TRUE(ends.lower && ends.upper);
    EXPECT_LE(*ends.lower, truth);
    EXPECT_LE(truth, *ends.upper);
    EXPECT_LT(ends.width(), width);
  };
  const auto dented = space::node(Kind::kDifference, {block({-8, -8, -48}, {8, 8, -32}), space::ball({8, 8, -32}, 3)});
  EXPECT_TRUE(drawn(K::kGamma1, dented, bowl())->proven);
  EXPECT_EQ(drawn(K::kGamma1, dented, bowl())->value, Real(12));
  const auto cup = space::node(Kind::kDifference, {space::ball({0, 0, 30}, 6), space::ball({0, 0, 33}, 5)});
  holds(drawn(K::kGamma1, cup, bowl()), sqrt(Real(325)) - Real(6), 4);
  holds(drawn(K::kGamma1, bowl(), cup), sqrt(Real(325)) - Real(6), 4);
  const auto shell = space::node(Kind::kDifference, {space::ball({0, 0, -5}, 4), space::ball({0, 0, -5}, 3)});
  holds(drawn(K::kGamma2, shell, bowl()), sqrt(Real(1425)) + Real(4), 8);
  holds(drawn(K::kEta1, shell, bowl()), Real(-6), 6);
  holds(drawn(K::kDelta1, bowl(), shell), Real(-6), 6);
  EXPECT_FALSE(drawn(K::kDelta1, shell, bowl()));
  const auto outside = space::node(Kind::kComplement, {cube(20)});
  holds(drawn(K::kGamma1, shell, outside), Real(11), 6);
  EXPECT_FALSE(drawn(K::kGamma2, shell, outside));
}

plane::ShapePtr cup() { return space::node(Kind::kDifference, {space::ball({0, 0, 0}, 6), space::ball({0, 0, 5}, 4)}); }

int sign_at(const plane::Section& line, const Real& t) {
  int sign = line.before;
  for (const plane::Section::Stop& stop : line.stops) {
    if (t < stop.t) break;
    sign = t == stop.t ? stop.at : stop.after;
  }
  return sign;
}

/// Signs are told where the bodies within one of them and about it agree.
TEST(CutSolid, HasSignsBesideAnotherOneWhereTheEndsTellThem) {
  using K = findspace::formula::Kind;
  SpaceWorld all = world("B");
  all.shapes["B"] = space_shape(*cup());
  const SpaceSolver solver(all);
  RayWorld rays;
  rays.shapes.emplace("A", RayShape(bowl()));
  rays.shapes.emplace("B", RayShape(cup()));
  rays.moving = {"B"};
  rays.step = Real(1);
  const std::vector<std::pair<K, int>> wanted{{K::kGamma2, 60}};
  for (const auto& [kind, level] : wanted) {
    const auto line = signs_on_line(rays, {named(kind), Real(level), false}, *grid_through(space::place(2, 1, 0), 2));
    ASSERT_TRUE(line) << line.refusal().error.what();
    EXPECT_TRUE(line->searched);
    std::array<int, 3> seen{};
    for (const int z : {-80, -30, 0, 31, 90}) {
      const int sign = sign_at(line->section, Real(z));
      const auto v = solver.value(named(kind), space::place(2, 1, z));
      ASSERT_TRUE(v);
      const distance::Enclosure ends = v->bounds();
      if (sign < 0) EXPECT_FALSE(ends.lower && Real(level) < *ends.lower);
      if (sign > 0) EXPECT_FALSE(ends.upper && *ends.upper < Real(level));
      ++seen[static_cast<std::size_t>(sign + 1)];
    }
    EXPECT_GT(seen[0], 0) << static_cast<int>(kind);
    EXPECT_GT(seen[2], 0) << static_cast<int>(kind);
  }
}

TEST(CutSolid, HasLeastValuesBesideAnotherOneBetweenEnds) {
  using K = findspace::formula::Kind;
  SpaceWorld all = world("B");
  all.shapes["B"] = space_shape(*cup());
  const SpaceSolver solver(all);
  EXPECT_EQ(solver.nearly_least(named(K::kD1))->value, Real());
  const auto least = solver.nearly_least(named(K::kGamma2));
  ASSERT_TRUE(least);
  const distance::Enclosure ends = least->bounds(), there = solver.value(named(K::kGamma2), least->at)->bounds();
  // Both are as wide as they are without what is cut out.
  EXPECT_LE(ends.lower->to_double(), 20 * std::sqrt(3.0) + 6 + 1e-9);
  EXPECT_GE(ends.upper->to_double(), 20 * std::sqrt(3.0) + 4);
  EXPECT_LE(*there.lower, *ends.upper);
}

/// A complement that moves: the other one moves in it the other way.
TEST(CutSolid, LiesInAComplementThatMoves) {
  using K = findspace::formula::Kind;
  for (const auto& inner : {cube(3), cup()}) {
    SpaceWorld all = world("B"), back = world("A");
    const auto outside = space::node(Kind::kComplement, {cube(20)});
    all.shapes["B"] = back.shapes["B"] = space_shape(*outside);
    all.shapes["A"] = back.shapes["A"] = space_shape(*inner);
    const SpaceSolver solver(all), other(back);
    const auto p = space::place(3, 1, 2), q = space::place(-3, -1, -2);
    for (const K kind : {K::kGamma1, K::kDelta1, K::kPenetration}) {
      const auto v = solver.value(named(kind), p);
      const auto w = other.value(named(kind), q);
      ASSERT_EQ(v.has_value(), w.has_value());
      if (v) EXPECT_EQ(v->value, w->value);
    }
    EXPECT_FALSE(solver.value(named(K::kEta1), p));
    EXPECT_THROW(solver.nearly_least(named(K::kGamma1)), Error);
    RayWorld rays;
    rays.shapes.emplace("A", RayShape(inner));
    rays.shapes.emplace("B", RayShape(outside));
    rays.moving = {"B"};
    rays.step = Real(1);
    const SignMap free{named(K::kGamma1), Real(), false};
    EXPECT_EQ(*sign_at_position(rays, free, space::place(0, 0, 0)), 1);
    EXPECT_EQ(*sign_at_position(rays, free, space::place(0, 0, 30)), -1);
  }
}

/// Of a value from 0 on, whatever it is, it is known that it is not less.
TEST(CutSolid, IsWhereAnEndAloneTells) {
  using K = findspace::formula::Kind;
  SpaceWorld all = world("B");
  all.shapes["B"] =
      space_shape(*space::node(Kind::kDifference, {space::ball({0, 0, 0}, 19), space::ball({0, 0, 5}, 4)}));
  const SpaceSolver solver(all);
  const auto p = space::place(0, 0, 0);
  const auto v = solver.value(named(K::kEta2), p);
  if (v) EXPECT_TRUE(solver.check(Formula(compare(named(K::kEta2), Relation::kGreaterEqual, Real())), p).holds);
}

/// What is taken away is closed: no wall stays where its parts touch, nor where it is flush with what it is taken from.
TEST(CutSolid, KeepsNoWalls) {
  using K = findspace::formula::Kind;
  const auto bite = space::ball({20, 20, 20}, 6);
  const auto pocket =
      space::node(Kind::kUnion, {block({-10, -10, -10}, {10, 0, 10}), block({-10, 0, -10}, {0, 10, 10})});
  const auto within = space::node(Kind::kDifference, {cube(20), bite, pocket});
  EXPECT_EQ(drawn(K::kGamma1, block({-8, -5, -5}, {-2, 5, 5}), within)->value, Real(2));
  const auto flush = space::node(Kind::kDifference, {cube(20), bite, block({-20, -10, -10}, {0, 10, 10})});
  EXPECT_EQ(drawn(K::kGamma1, block({-30, -6, -6}, {-23, 6, 6}), flush)->value, Real(5));
  const auto half = space::node(Kind::kDifference, {space::ball({0, 0, 0}, 10), block({-10, -10, -10}, {0, 10, 10})});
  EXPECT_EQ(drawn(K::kGamma1, block({-30, -2, -2}, {-20, 3, 3}), half)->value, Real(20));
  const auto oblique = space::node(Kind::kDifference,
                                   {cube(20), bite, space::hull({{-20, -9, 0}, {-20, 9, 0}, {-20, 0, 9}, {-3, 1, 4}})});
  EXPECT_EQ(drawn(K::kGamma1, block({-30, 0, 3}, {-21, 1, 4}), oblique)->value.sign(), 1);
  EXPECT_NE(drawn(K::kGamma1, block({-30, 0, 3}, {-21, 1, 4}), oblique)->value, Real(1));
}

/// Nor in what a union leaves of space.
TEST(CutSolid, IsGluedToAPlate) {
  using K = findspace::formula::Kind;
  const auto glued = space::node(Kind::kUnion, {bowl(), block({-30, -30, -30}, {30, 30, -20})});
  const auto across = drawn(K::kEta1, block({-5, -5, -25}, {0, 0, -15}), glued);
  ASSERT_TRUE(across);
  EXPECT_EQ(across->value, Real(-5));
}

/// By so many steps, or shrunk.
plane::ShapePtr grown(const plane::ShapePtr& shape, std::int64_t by) {
  plane::Shape out;
  out.kind = Kind::kOffset;
  out.amount = Real(by);
  out.children = {shape};
  return std::make_shared<const plane::Shape>(out);
}

/// What its parts alone say is refused, as they hold a wall; whether another fits is known by what it is cut out of.
TEST(CutSolid, SaysWhatFitsWhereARoundedPartIsFlush) {
  using K = findspace::formula::Kind;
  const auto rounded = grown(block({-17, -7, -7}, {0, 7, 7}), 3);
  const auto flush = space::node(Kind::kDifference, {cube(20), rounded});
  const auto open = space::node(Kind::kDifference, {cube(18), rounded});
  const auto lower = block({-10, -5, -18}, {0, 5, -12});
  EXPECT_EQ(drawn(K::kEta1, lower, flush)->value, Real(-2));
  EXPECT_EQ(drawn(K::kMu, lower, flush)->value, Real(-2));
  EXPECT_TRUE(drawn(K::kEta2, lower, flush));
  const auto outside = block({-30, -2, -2}, {-25, 2, 2});
  EXPECT_THROW(drawn(K::kGamma1, outside, flush), Error);
  EXPECT_THROW(drawn(K::kGamma2, outside, flush), Error);
  EXPECT_THROW(drawn(K::kMu, outside, flush), Error);
  EXPECT_THROW(drawn(K::kEta1, flush, cube(30)), Error);
  EXPECT_TRUE(drawn(K::kGamma1, outside, open));
  const auto glued = space::node(Kind::kUnion, {flush, block({20, -20, -20}, {30, 20, 20})});
  EXPECT_EQ(drawn(K::kEta1, lower, glued)->value, Real(-2));
  EXPECT_THROW(drawn(K::kGamma1, outside, glued), Error);

  RayWorld rays;
  rays.shapes.emplace("A", RayShape(flush));
  rays.shapes.emplace("B", RayShape(lower));
  rays.moving = {"B"};
  rays.step = Real(1);
  const SignMap in{named(K::kEta1), Real(), false}, apart{named(K::kGamma1), Real(5), false};
  EXPECT_EQ(*sign_at_position(rays, in, space::place(0, 0, 0)), -1);
  EXPECT_FALSE(signs_on_line(rays, apart, *grid_through(space::place(0, 0, -60), 2)));
}

/// Two steps are flush only where the step between them is taken away, too.
TEST(CutSolid, IsAShrunkStaircase) {
  std::vector<plane::ShapePtr> steps;
  for (std::int64_t k = 0; k < 6; ++k)
    steps.push_back(block({2 * k, 0, -10}, {2 * k + (k < 5 ? 2 : 9), 10, 2 * k + 2}));
  const auto shrunk = grown(space::node(Kind::kUnion, steps), -1);
  EXPECT_EQ(drawn(findspace::formula::Kind::kGamma1, block({8, 2, -20}, {10, 8, -11}), shrunk)->value, Real(2));
}

/// Both cylinders are one between the ends.
TEST(CutSolid, HasNoValueWhereRoundFacesAreFlush) {
  using K = findspace::formula::Kind;
  const auto capsule = [](std::int64_t from, std::int64_t to, std::int64_t radius) {
    return space::node(Kind::kHull, {space::ball({from, 0, 0}, radius), space::ball({to, 0, 0}, radius)});
  };
  const auto near = block({6, -2, 5}, {8, 2, 6});
  EXPECT_THROW(drawn(K::kGamma1, near, space::node(Kind::kDifference, {capsule(0, 10, 2), capsule(4, 20, 2)})), Error);
  EXPECT_TRUE(drawn(K::kGamma1, near, space::node(Kind::kDifference, {capsule(0, 10, 2), capsule(4, 20, 3)})));
  EXPECT_THROW(drawn(K::kGamma1, near, space::node(Kind::kDifference, {capsule(0, 10, 2), space::ball({0, 0, 0}, 2)})),
               Error);
  EXPECT_TRUE(drawn(K::kGamma1, near, space::node(Kind::kDifference, {capsule(0, 10, 2), capsule(10, 20, 2)})));
  EXPECT_TRUE(drawn(K::kGamma1, near, space::node(Kind::kDifference, {capsule(0, 4, 2), capsule(8, 20, 2)})));
}

/// Cells would need steps so fine that a ball far away had no place among them.
TEST(CutSolid, KeepsItsStepsWhereABallIsFarAway) {
  constexpr std::int64_t kFar = 1000000000, kHalf = 1000000;
  const auto dish = space::ball({0, 0, kFar}, kFar);
  const auto cut = space::hull({{-kHalf, -9, -500}, {-kHalf, 9, -500}, {-kHalf, 0, -491}, {-3, 1, -496}});
  EXPECT_TRUE(try_space_shape(*space::node(Kind::kDifference, {cube(kHalf), dish, cut})));
}

TEST(CutSolid, HasSignsWhereItHasNoValue) {
  RayWorld rays;
  rays.shapes.emplace("A", RayShape(bowl()));
  rays.shapes.emplace("B", RayShape(cube(3)));
  rays.moving = {"B"};
  rays.step = Real(1);
  const SignMap touching{named(findspace::formula::Kind::kGamma1), Real(), false};
  EXPECT_EQ(*sign_at_position(rays, touching, space::place(0, 0, 3)), -1);
  EXPECT_EQ(*sign_at_position(rays, touching, space::place(0, 0, 17)), 1);
  EXPECT_TRUE(signs_on_line(rays, touching, *grid_through(space::place(0, 0, 3), 2))->searched);
}

/// A bowl, a plate below it and another bowl as one obstacle, or as what moves.
TEST(CutSolid, IsOneOfSeveral) {
  using K = findspace::formula::Kind;
  const plane::ShapePtr plate = space::hull({{-20, -20, -30},
                                             {20, -20, -30},
                                             {-20, 20, -30},
                                             {20, 20, -30},
                                             {-20, -20, -40},
                                             {20, -20, -40},
                                             {-20, 20, -40},
                                             {20, 20, -40}});
  SpaceWorld all = world("B");
  all.shapes["P"] = space_shape(*plate);
  all.shapes["Q"] = space_shape(*space::node(Kind::kDifference, {cube(20), space::ball({0, 0, -20}, 15)}));
  const SpaceSolver solver(all);
  Distance several = named(K::kGamma1), farthest = named(K::kGamma2);
  several.second = {"A", "P"};
  farthest.second = {"A", "P"};
  EXPECT_EQ(solver.value(several, space::place(0, 0, 17))->value, Real(15) - sqrt(Real(54)));
  EXPECT_EQ(solver.value(several, space::place(-15, 0, -44))->value, Real(1));
  Distance plate_alone = named(K::kGamma2);
  plate_alone.second = {"P"};
  EXPECT_EQ(solver.value(farthest, space::place(0, 0, 17))->value,
            solver.value(plate_alone, space::place(0, 0, 17))->value);
  // With the other bowl the pocket is filled.
  several.second = {"A", "Q"};
  EXPECT_EQ(solver.value(several, space::place(0, 0, 24))->value, Real(1));

  all.moving = {"A", "P"};
  const SpaceSolver back(all);
  Distance moved = named(K::kGamma1, true);
  moved.first = {"A", "P"};
  EXPECT_EQ(back.value(moved, space::place(0, 0, -17))->value, Real(15) - sqrt(Real(54)));

  RayWorld rays;
  rays.shapes.emplace("A", RayShape(bowl()));
  rays.shapes.emplace("P", RayShape(plate));
  rays.shapes.emplace("B", RayShape(cube(3)));
  rays.moving = {"B"};
  rays.step = Real(1);
  SignMap touching{named(K::kGamma1), Real(), false};
  touching.distance.second = {"A", "P"};
  EXPECT_EQ(*sign_at_position(rays, touching, space::place(0, 0, 17)), 1);
  EXPECT_EQ(*sign_at_position(rays, touching, space::place(0, 0, -25)), 1);
}

}  // namespace formula_cut_solid
}  // namespace findspace::formula
