// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing through the public headers alone: conditions of pairs, fixed parts, zones that hold parts.

#include <gtest/gtest.h>

#include <cmath>

#include "findspace/error.h"
#include "findspace/packing.h"

namespace io_public_packing {

using namespace findspace;

Ring box_ring(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// Two dots and a block as high as the strip.
PackProblem dots_and_block() {
  PackProblem problem;
  problem.height = 4;
  problem.parts = {
      {"a", {box_ring(0, 0, 1, 1)}}, {"b", {box_ring(0, 0, 1, 1)}}, {"block", {box_ring(0, 0, 4, 4)}, 1, {0, 90}}};
  return problem;
}

TEST(PublicPacking, AGreatestDistance) {
  PackProblem problem = dots_and_block();
  problem.conditions = {{"a", "b", "gap(self, other) <= 0.5"}};
  const auto layout = pack(problem, {.seconds = 0, .work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->length.text(), "5");
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  PackProblem wide = problem;
  wide.conditions[0].where = "gap(self, other) >= 3.5";  // in a column of height 4 the dots are 2 apart at most
  ASSERT_EQ(layout_faults(wide, *layout).size(), 1u);
  EXPECT_NE(layout_faults(wide, *layout)[0].find("condition"), std::string::npos);
}

TEST(PublicPacking, AFormulaOfAllPairsAndAGroup) {
  PackProblem problem = dots_and_block();
  problem.where = "reach(self, other) <= 6";
  const auto layout = pack(problem, {.seconds = 0, .work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->length.text(), "5");
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  problem.where = "reach(self, other) <= 3";  // less than the diagonal of a dot and the block
  EXPECT_EQ(layout_faults(problem, *layout).size(), 2u);
  problem.where = "gap(self, nobody) <= 3";
  EXPECT_THROW(layout_faults(problem, *layout), Error);
  problem.where.clear();
  problem.groups = {{{"a", "b"}}};
  EXPECT_THROW(layout_faults(problem, *layout), Error);  // a strip needs a distance
  problem.groups[0].within = 0;
  EXPECT_EQ(pack(problem, {.seconds = 0, .work = 2})->length.text(), "5");
  problem.groups[0].parts[1] = "nobody";
  EXPECT_THROW(layout_faults(problem, *layout), Error);
}

TEST(PublicPacking, AGroupLiesOnOneSheet) {
  PackProblem problem;
  problem.sheets = {PackSheet::rectangle("plate", 2, 1, 2)};
  problem.parts = {{"a", {box_ring(0, 0, 1, 1)}}, {"b", {box_ring(0, 0, 1, 1)}}, {"c", {box_ring(0, 0, 2, 1)}}};
  problem.groups = {{{"a", "b"}}};
  PackLayout apart;
  apart.sheets = {"plate", "plate"};
  apart.length = 1;
  apart.items = {{.part = "a"}, {.part = "b", .sheet = 1}};
  apart.left_out = {{"c", 1, ""}};
  ASSERT_EQ(layout_faults(problem, apart).size(), 1u);
  const auto layout = pack(problem, {.seconds = 0, .work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->items.size(), 3u);
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
}

TEST(PublicPacking, JsonIsReadInItsWords) {
  const PackProblem problem = pack_problem(R"({"name": "kit", "strip_height": 4, "where": "gap(self, other) <= 9",
    "items": [{"id": "a", "demand": 2, "shape": {"type": "simple_polygon", "data": [[0,0], [1,0], [1,1.5]]}}],
    "pairs": [{"between": ["a", "a"], "where": "reach(self, other) <= 8"}],
    "groups": [{"parts": ["a"], "within": 2.5}]})");
  EXPECT_EQ(problem.where, "gap(self, other) <= 9");
  ASSERT_EQ(problem.conditions.size(), 1u);
  ASSERT_EQ(problem.groups.size(), 1u);
  EXPECT_EQ(problem.groups[0].within->text(), "2.5");
  EXPECT_EQ(problem.parts[0].rings[0][2].y.text(), "1.5");
  EXPECT_TRUE(pack(problem, {.seconds = 0, .work = 1}).has_value());
}

TEST(PublicPacking, AFixedPartStandsAtItsAngle) {
  PackProblem problem = dots_and_block();
  problem.fixed = {{.part = "a", .x = 6, .y = 1, .angle = 45}};
  const auto layout = pack(problem, {.seconds = 0, .work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_NEAR(std::stod(layout->length.text()), 6 + std::sqrt(0.5), 1e-5);  // not on the grid of whole numbers
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  problem.fixed[0].y = 3;
  EXPECT_THROW(pack(problem, {.seconds = 0, .work = 1}), Error);  // it reaches beyond the strip
}

TEST(PublicPacking, AZoneHoldsOrKeepsOut) {
  PackProblem problem = dots_and_block();
  problem.sheets = {PackSheet::rectangle("plate", 9, 4)};
  problem.sheets[0].zones = {{{box_ring(5, 0, 9, 4)}, {}, {"block"}}};
  const auto layout = pack(problem, {.seconds = 0, .work = 2});
  ASSERT_TRUE(layout.has_value());
  ASSERT_EQ(layout->items.size(), 3u);
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  EXPECT_EQ(layout->length.text(), "9");  // the block lies in the zone
  problem.sheets[0].zones[0].keeps_out = {"a"};
  EXPECT_THROW(pack(problem, {.seconds = 0, .work = 1}), Error);
}

}  // namespace io_public_packing
