// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Balls, rotations of rational entries, gaps of pairs and conditions between solids: proofs at exact contacts, and
// searches that must find what is known.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>

#include "packing/solid_depth/solid_table.h"
#include "packing/solid_problem/solid_pair_formula.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_proof/verify_solids.h"
#include "packing/solid_search/solid_search.h"
#include "packing_solid_parts.h"

namespace findspace::packing {
namespace packing_round_solids {

space::BodyPart ball_at(const space::Point& center, int radius) {
  return space::part_of(std::vector<space::Point>{center}, exact::Real(radius));
}

SolidPart ball(const char* name, int demand, int radius) { return part_of(name, demand, {ball_at({0, 0, 0}, radius)}); }

SolidProblem problem_of(Fraction width, Fraction depth, std::vector<SolidPart> parts) {
  SolidProblem problem;
  problem.width = width;
  problem.depth = depth;
  problem.parts = std::move(parts);
  return problem;
}

std::optional<SolidLayout> searched(const SolidProblem& problem, double work) {
  const std::atomic<bool> stop = false;
  SolidSearchOptions options;
  options.work = work;
  return search_solids(problem, options, {}, stop);
}

SolidLayout found(const SolidProblem& problem, double work) {
  const auto layout = searched(problem, work);
  EXPECT_TRUE(verify(problem, layout.value()).is_feasible());
  return *layout;
}

using Kind = SolidFault::Kind;

Kind first_fault(const SolidProblem& problem, const SolidLayout& layout) {
  return verify(problem, layout).faults.at(0).kind;
}

/// (3, 4, 12) is 13 long.
TEST(SolidVerify, BallsTouch) {
  SolidProblem problem = problem_of(40, 40, {part_of("a", 1, {ball_at({0, 0, 0}, 6)}), ball("b", 1, 7)});
  SolidLayout layout{40, {{0, 1, 0, {9, 9, 9}}, {1, 1, 0, {12, 13, 21}}}};
  EXPECT_TRUE(verify(problem, layout).is_feasible());
  layout.items[1].at[0] = Fraction(11999999999, 1000000000);
  ASSERT_EQ(first_fault(problem, layout), Kind::kOverlap);
  EXPECT_GT(verify(problem, layout).faults[0].depth, 0);
  layout.items[1].at[0] = 12;
  problem.gap = Fraction(1, 1000000000);
  EXPECT_EQ(first_fault(problem, layout), Kind::kGap);
  layout.items[0].at[2] = Fraction(599, 100);
  EXPECT_EQ(first_fault(problem, layout), Kind::kOutside);
}

/// A ball at the corner of a box: (6, 6, 7) is 11 long.
TEST(SolidVerify, ABallAtACorner) {
  const SolidProblem problem = problem_of(40, 40, {box("box", 1, 4, 4, 4), ball("ball", 1, 11)});
  SolidLayout layout{40, {{0, 1, 0, {1, 1, 1}}, {1, 1, 0, {11, 11, 12}}}};
  EXPECT_TRUE(verify(problem, layout).is_feasible());
  layout.items[1].at[2] = Fraction(11999999999, 1000000000);
  EXPECT_EQ(first_fault(problem, layout), Kind::kOverlap);
}

TEST(SolidBound, OfBalls) {
  const SolidProblem problem = problem_of(2, 2, {ball("ball", 3, 1)});
  EXPECT_NEAR(lower_bound(problem).to_double(), std::acos(-1.0), 1e-8);
  EXPECT_EQ(lower_bound(problem_of(9, 9, {ball("ball", 3, 1)})), Fraction(2));
}

/// Upon each other between walls that are 3 apart: they stand by 1 to the side, and by the root of 3 higher.
TEST(SolidSearch, StacksBalls) {
  const SolidLayout layout = found(problem_of(2, 3, {ball("ball", 2, 1)}), 10e6);
  EXPECT_NEAR(layout.height.to_double(), 2 + std::sqrt(3.0), 1e-6);
}

/// Four balls and a box between them.
TEST(SolidSearch, BallsAndBoxes) {
  const SolidProblem problem = problem_of(6, 6, {ball("ball", 4, 1), box("box", 2, 4, 4, 1), ball("large", 1, 2)});
  const SolidLayout layout = found(problem, 20e6);
  EXPECT_LT(layout.height.to_double(), 8);
}

TEST(SolidTable, AFormOfTwoBallsIsNotThatOfThemSwapped) {
  SolidPart pair = part_of("pair", 1, {ball_at({0, 0, 0}, 1), ball_at({0, 0, 4}, 2)});
  const SolidForm form = pair.forms[0];
  pair.forms.clear();
  for (const SolidRotation& rotation : axis_rotations(false)) pair.forms.push_back(turned(form, rotation));
  const SolidProblem problem = problem_of(20, 20, {pair});
  EXPECT_EQ(SolidTable(problem).variants_of(0).size(), 6U);
}

/// About z by the angle of the triangle 3, 4, 5.
SolidRotation pythagorean() {
  return {{{Fraction(3, 5), Fraction(-4, 5), 0}, {Fraction(4, 5), Fraction(3, 5), 0}, {0, 0, 1}}};
}

TEST(SolidForm, TurnsExactly) {
  const SolidProblem problem = problem_of(9, 9, {box("slab", 1, 2, 1, 1)});
  const SolidForm form = turned(problem.parts[0].forms[0], pythagorean());
  const SolidBox bounds = box_of(problem, form);
  EXPECT_EQ(bounds.low, (std::array<Fraction, 3>{Fraction(-4, 5), 0, 0}));
  EXPECT_EQ(bounds.high, (std::array<Fraction, 3>{Fraction(6, 5), Fraction(11, 5), 1}));
  EXPECT_EQ(form.body.scale, 5);
  // A slab of five steps needs no finer ones.
  EXPECT_EQ(turned(box("slab", 1, 10, 5, 1).forms[0], pythagorean()).body.scale, 1);
  const std::int64_t p = 1000000007;
  const SolidRotation fine{{{Fraction(p * p - 1, p * p + 1), Fraction(-2 * p, p * p + 1), 0},
                            {Fraction(2 * p, p * p + 1), Fraction(p * p - 1, p * p + 1), 0},
                            {0, 0, 1}}};
  EXPECT_THROW(turned(problem.parts[0].forms[0], fine), Error);
}

/// Turned slabs touch along a slanted face.
TEST(SolidVerify, TurnedPartsTouch) {
  SolidProblem problem = problem_of(40, 40, {box("slab", 2, 10, 1, 1)});
  problem.parts[0].forms[0] = turned(problem.parts[0].forms[0], pythagorean());
  SolidLayout layout{2, {{0, 1, 0, {9, 9, 0}}, {0, 2, 0, {Fraction(41, 5), Fraction(48, 5), 0}}}};
  EXPECT_TRUE(verify(problem, layout).is_feasible());  // moved by the side of 1, turned
  layout.items[1].at[0] = layout.items[1].at[0] + Fraction(1, 1000000000);
  EXPECT_EQ(first_fault(problem, layout), Kind::kOverlap);
}

/// A slab longer than the sides of the floor lies in its diagonal.
TEST(SolidSearch, TurnsByAnyRotation) {
  SolidPart slab = box("slab", 2, 10, 1, 1);
  const SolidForm form = slab.forms[0];
  slab.forms.push_back(turned(form, pythagorean()));
  const SolidProblem problem = problem_of(8, 10, {slab});
  const SolidLayout layout = found(problem, 10e6);
  EXPECT_EQ(layout.items[0].form, 1U);
  EXPECT_EQ(layout.height, Fraction(1));
}

TEST(SolidSearch, KeepsGapsOfPairs) {
  SolidProblem problem = problem_of(9, 1, {box("a", 1, 2, 1, 2), box("b", 1, 2, 1, 2), box("c", 1, 2, 1, 2)});
  problem.pair_gaps.push_back({0, 1, 3});
  const SolidLayout layout = found(problem, 10e6);
  EXPECT_EQ(layout.height, Fraction(2));
  SolidLayout wrong = layout;
  for (int k = 0; k < 3; ++k) wrong.items[std::size_t(k)].at = {2 * k, 0, 0};
  EXPECT_EQ(first_fault(problem, wrong), Kind::kGap);
}

/// Of four cubes on a long floor two stay near each other.
TEST(SolidSearch, KeepsConditions) {
  SolidProblem problem = problem_of(20, 2, {box("a", 1, 2, 2, 2), box("b", 1, 2, 2, 2), box("c", 2, 2, 2, 2)});
  problem.conditions = {{0, 1, "gap(self, other) <= 1 and reach(self, other) <= 6"}, {2, 2, "gap(self, other) >= 9"}};
  const SolidLayout layout = found(problem, 20e6);
  EXPECT_EQ(layout.height, Fraction(2));
  SolidLayout wrong = layout;
  wrong.items = {{0, 1, 0, {0, 0, 0}}, {1, 1, 0, {4, 0, 0}}, {2, 1, 0, {7, 0, 0}}, {2, 2, 0, {18, 0, 0}}};
  EXPECT_EQ(first_fault(problem, wrong), Kind::kCondition);
  wrong.items[1].at[0] = 3;
  EXPECT_TRUE(verify(problem, wrong).is_feasible());
}

/// `self` is a copy of the first part, whatever the order of the parts.
TEST(SolidVerify, ConditionsHaveAnOrder) {
  SolidProblem problem = problem_of(20, 20, {box("small", 1, 1, 1, 1), box("large", 1, 4, 4, 4)});
  const SolidLayout layout{9, {{0, 1, 0, {0, 0, 0}}, {1, 1, 0, {1, 0, 0}}}};
  problem.conditions = {{0, 1, "protrusion(self, other) <= 1"}};
  EXPECT_TRUE(verify(problem, layout).is_feasible());
  problem.conditions = {{1, 0, "protrusion(self, other) <= 1"}};
  EXPECT_EQ(first_fault(problem, layout), Kind::kCondition);
}

/// Farther than the floor is wide: one stands high above the other.
TEST(SolidSearch, SolidsThatMustBeFarApart) {
  SolidProblem problem = problem_of(5, 5, {box("a", 1, 4, 4, 4), box("b", 1, 4, 4, 4)});
  problem.conditions = {{0, 1, "gap(self, other) >= 300"}};
  EXPECT_LT(found(problem, 20e6).height.to_double(), 308.01);
  problem.containers = {{"tower", 1, {}, 5, 5, 310}};
  const SolidLayout layout = found(problem, 4e6);
  EXPECT_EQ(layout.items.size(), 2U);
}

/// Along a direction, exactly, and one way as `self` goes, whichever comes first in the layout.
TEST(SolidVerify, ConditionsAlongADirection) {
  SolidPart angle = part_of("angle", 1, {block({0, 0, 0}, {4, 1, 1}), block({0, 0, 1}, {1, 1, 4})});
  SolidProblem problem = problem_of(10, 10, {angle, box("b", 1, 2, 1, 1)});
  const auto holds = [&](const char* where, Fraction z) {
    problem.conditions = {{0, 1, where}};
    SolidLayout layout{9, {{0, 1, 0, {0, 0, 0}}, {1, 1, 0, {2, 0, z}}}};
    const bool result = verify(problem, layout).is_feasible();
    std::swap(layout.items[0], layout.items[1]);
    EXPECT_EQ(verify(problem, layout).is_feasible(), result) << where;
    return result;
  };
  EXPECT_TRUE(holds("gap(self, other, along=(0, 0, 1)) >= 2", 3));  // over the foot, beside the leg
  EXPECT_FALSE(holds("gap(self, other, along=(0, 0, 1)) >= 2.000001", 3));
  EXPECT_TRUE(holds("gap(self, other, along=(1, 0, 0)) <= 1", 3));
  EXPECT_TRUE(holds("gap(self, other, along=(0, 1, 0)) > 1000", 6));
  EXPECT_FALSE(holds("gap(self, other, toward=(0, 0, 1)) >= 3", 3));
  EXPECT_TRUE(holds("gap(self, other, toward=(0, 0, -1)) >= 3", 3));
  check_conditions(problem, "");
  problem.parts[1] = ball("b", 1, 1);
  EXPECT_THROW(check_conditions(problem, ""), Error);
}

/// What holds in contact alone, or at one level.
TEST(SolidSearch, KeepsConditionsThatAreTight) {
  SolidProblem problem = problem_of(6, 6, {box("a", 1, 2, 2, 2), box("b", 1, 1, 1, 1), box("c", 1, 1, 2, 1)});
  for (const char* where : {"gap(self, other) <= 0", "touches(self, other)", "gap(self, other) = 1",
                            "not gap(self, other) > 0", "gap(self, other) >= 1 and gap(self, other) <= 1.01"}) {
    problem.conditions = {{0, 1, where}, {0, 2, where}};
    EXPECT_EQ(found(problem, 4e6).height, Fraction(2)) << where;
  }
}

TEST(SolidSearch, KeepsConditionsAlongADirection) {
  SolidProblem problem = problem_of(4, 4, {box("a", 1, 4, 4, 1), box("b", 2, 2, 2, 1)});
  problem.conditions = {{0, 1, "gap(self, other, along=(0, 0, 1)) >= 2"}, {1, 1, "gap(self, other) <= 1"}};
  EXPECT_NEAR(found(problem, 2e6).height.to_double(), 4, 0.2);
}

TEST(SolidSearch, SaysWhereNoConditionCanHold) {
  SolidProblem problem = problem_of(6, 6, {box("cube", 2, 2, 2, 2)});
  problem.conditions = {{0, 0, "reach(self, other) <= 3"}};
  EXPECT_FALSE(searched(problem, 4e6).has_value());
}

/// In different containers parts are infinitely far apart.
TEST(SolidSearch, ConditionsHoldInOneContainer) {
  SolidProblem problem = problem_of(0, 0, {box("cube", 4, 2, 2, 2)});
  problem.containers = {{"crate", 9, {}, 4, 2, 2}};
  EXPECT_EQ(found(problem, 4e6).containers.size(), 2U);
  SolidLayout layout = found(problem, 4e6);
  problem.conditions = {{0, 0, "gap(self, other) <= 1"}};
  EXPECT_EQ(first_fault(problem, layout), Kind::kCondition);
  const auto kept = searched(problem, 8e6);
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->containers.size(), 1U);
  EXPECT_EQ(kept->items.size(), 2U);
}

}  // namespace packing_round_solids
}  // namespace findspace::packing
