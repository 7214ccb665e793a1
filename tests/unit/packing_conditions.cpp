// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Conditions of pairs, parts that stand already, and zones that hold parts: what the search finds and verify says.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <atomic>

#include "packing/problem/pair_formula.h"
#include "packing/problem/round_part.h"
#include "packing/proof/verify.h"
#include "packing/search/strip_search.h"
#include "packing_found.h"

namespace findspace::packing {
namespace packing_conditions {

Ring box_ring(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Polygon box(int w, int h) { return make_polygon({box_ring(0, 0, w, h)}, "box"); }

/// Two dots and a block that would lie between them.
Problem dots_and_block() {
  Problem problem;
  problem.height = 4;
  problem.parts = {{"a", 1, box(1, 1), {0}}, {"b", 1, box(1, 1), {0}}, {"block", 1, box(4, 4), {0}}};
  return problem;
}

TEST(PairFormula, HoldsAndItsRegion) {
  Problem problem = dots_and_block();
  problem.conditions.push_back({0, 1, "gap(self, other) <= 2"});
  const plane::Region dot = region_of(box(1, 1));
  const PairFormula forward(problem, 0, dot, 1, dot, exact::Real(1)), back(problem, 1, dot, 0, dot, exact::Real(1));
  EXPECT_TRUE(forward.holds(3, 0));
  EXPECT_TRUE(back.holds(-3, 0));
  EXPECT_FALSE(forward.holds(Fraction::parse("3.000000001"), 0));
  EXPECT_FALSE(forward.holds(3, Fraction::parse("1.1")));  // beyond the arc about the corner
  EXPECT_EQ(forward.regions().size(), 1u);
  EXPECT_EQ(greatest_level(problem.conditions), 2);
}

TEST(PairFormula, OneThatHasADirection) {
  Problem problem = dots_and_block();
  problem.conditions.push_back({2, 0, "protrusion(other, self) <= 3"});
  const plane::Region dot = region_of(box(1, 1)), block = region_of(box(4, 4));
  EXPECT_TRUE(PairFormula(problem, 2, block, 0, dot, exact::Real(1)).holds(6, 0));
  EXPECT_FALSE(PairFormula(problem, 2, block, 0, dot, exact::Real(1)).holds(7, 0));
  EXPECT_TRUE(PairFormula(problem, 0, dot, 2, block, exact::Real(1)).holds(-6, 0));
}

TEST(PairFormula, OneWayIsThatOfSelf) {
  Problem problem = dots_and_block();
  problem.conditions.push_back({0, 2, "gap(self, other, toward=(1, 0)) >= 5"});
  const plane::Region dot = region_of(box(1, 1)), block = region_of(box(4, 4));
  const auto holds = [&](int ahead) {
    const bool first = PairFormula(problem, 0, dot, 2, block, exact::Real(1)).holds(ahead, 0);
    EXPECT_EQ(PairFormula(problem, 2, block, 0, dot, exact::Real(1)).holds(-ahead, 0), first);
    return first;
  };
  EXPECT_FALSE(holds(4));  // the dot meets the block after 3
  EXPECT_TRUE(holds(7));
  EXPECT_TRUE(holds(-8));  // it goes away from it
}

TEST(PairFormula, ThatIsNone) {
  EXPECT_THROW(parse_condition("gap(self, nobody) <= 1"), Error);
  EXPECT_THROW(parse_condition("gap(self, other) <="), Error);
  for (const char* asked : {"gap(self, other, rotating=(0, 0)) >= 120", "2 * gap(self, other) <= reach(self, other)"})
    EXPECT_THROW(parse_condition(asked), Error) << asked;
  EXPECT_THROW(parse_condition("2 * gap(self, other) <= reach(self, other)", 3), Error);
  EXPECT_THROW(parse_condition("gap(self, other) <= 1e29"), Error);  // no place of a layout is so far away
}

TEST(Conditions, AGreatestDistance) {
  Problem problem = dots_and_block();
  problem.conditions.push_back({0, 1, "gap(self, other) <= 0.5"});
  EXPECT_EQ(found(problem, 1e7).length, Fraction(5));  // both dots on one side of the block
  Layout apart{6, {{0, 1, 0, false, 0, 0}, {1, 1, 0, false, 5, 0}, {2, 1, 0, false, 1, 0}}, {}};
  const Verdict verdict = verify(problem, apart);
  ASSERT_EQ(verdict.faults.size(), 1u);
  EXPECT_EQ(verdict.faults[0].kind, Fault::Kind::kCondition);
}

TEST(Conditions, OfTwoCopiesOfAPart) {
  Problem problem;
  problem.height = 1;
  problem.digits = 1;
  problem.parts = {{"a", 3, box(10, 10), {0}}};
  problem.conditions.push_back({0, 0, "gap(self, other) >= 0.5 and gap(self, other) <= 4"});
  EXPECT_NEAR(found(problem, 1e7).length.to_double(), 4, 1e-6);
  problem.conditions[0].where = "gap(self, other) = 3 and gap(self, other) > 3";
  const std::atomic<bool> stop = false;
  SearchOptions options;
  options.work = 1e6;
  EXPECT_FALSE(search_strip(problem, options, {}, stop).has_value());
}

TEST(Conditions, OnDifferentSheetsPartsAreFarApart) {
  Problem problem;
  problem.sheets.push_back({"plate", 2, {}, box(4, 4)});
  problem.parts = {{"a", 1, box(2, 4), {0}}, {"b", 1, box(2, 4), {0}}, {"c", 1, box(2, 4), {0}}};
  problem.conditions.push_back({0, 2, "gap(self, other) <= 8"});
  const Layout layout = found(problem, 1e7);
  ASSERT_EQ(layout.items.size(), 3u);
  std::vector<std::size_t> sheets(3);
  for (const Placed& item : layout.items) sheets[item.part] = item.sheet;
  EXPECT_EQ(sheets[0], sheets[2]);
  EXPECT_NE(sheets[0], sheets[1]);
  Layout apart = layout;  // b and c exchanged
  for (Placed& item : apart.items)
    if (item.part > 0) item.part = 3 - item.part;
  EXPECT_EQ(verify(problem, apart).faults.at(0).kind, Fault::Kind::kCondition);
}

TEST(Fixed, OthersLieAroundThem) {
  Problem problem;
  problem.height = 2;
  problem.parts = {{"a", 3, box(2, 2), {0}}, {"b", 1, box(1, 2), {0}}};
  problem.fixed.push_back({{0, 1, 90, false, 4, 0}});  // its angle is none of those allowed
  const Layout layout = found(problem, 4e6);
  EXPECT_EQ(layout.items.size(), 4u);
  EXPECT_EQ(layout.items[0].angle, Fraction(90));
  EXPECT_EQ(layout.length, Fraction(7));  // one before it, two behind
  Layout moved = layout;
  moved.items[0].x = Fraction(5);
  EXPECT_FALSE(verify(problem, moved).feasible());
}

TEST(Fixed, AllOfThem) {
  Problem problem;
  problem.height = 2;
  problem.parts = {{"a", 1, box(2, 2), {0}}};
  problem.fixed.push_back({{0, 1, 0, false, 1, 0}});
  EXPECT_EQ(found(problem, 1e6).length, Fraction(3));
}

TEST(Fixed, OnASheet) {
  Problem problem;
  problem.sheets.push_back({"cheap", 3, Fraction(1), box(4, 4)});
  problem.sheets.push_back({"dear", 1, Fraction(9), box(4, 4)});
  problem.parts = {{"a", 2, box(4, 2), {0}}, {"b", 2, box(4, 2), {0}}};
  problem.fixed.push_back({{0, 1, 0, false, 0, 1, 0}, 1});
  const Layout layout = found(problem, 1e7);
  ASSERT_EQ(layout.items.size(), 4u);
  EXPECT_EQ(layout.sheets.at(layout.items[0].sheet), 1u);
  EXPECT_EQ(layout.sheets.size(), 3u);  // beside the fixed one no other has room
}

TEST(Zones, ThatHoldAPart) {
  Problem problem;
  problem.sheets.push_back({"plate", 1, {}, box(9, 4)});
  problem.parts = {{"a", 2, box(2, 2), {0}}, {"b", 1, box(2, 4), {0}}};
  problem.sheets[0].zones.push_back({make_polygon({box_ring(5, 0, 7, 4)}, "zone"), {0}, true});
  const Layout layout = found(problem, 1e7);
  ASSERT_EQ(layout.items.size(), 3u);
  for (const Placed& item : layout.items)
    if (item.part == 0) {
      EXPECT_EQ(item.x, Fraction(5));
    }
  Layout wrong = layout;
  for (Placed& item : wrong.items)
    if (item.part == 0) item.x = Fraction(4);  // b leaves the largest rectangle free at one end
  EXPECT_EQ(verify(problem, wrong).faults.at(0).kind, Fault::Kind::kZone);
}

}  // namespace packing_conditions
}  // namespace findspace::packing
