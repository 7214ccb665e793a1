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
  const auto layout = pack(problem, {.threads = 1, .work = 2});
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
  const auto layout = pack(problem, {.threads = 1, .work = 2});
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
  EXPECT_EQ(pack(problem, {.threads = 1, .work = 2})->length.text(), "5");
  problem.groups[0].parts[1] = "nobody";
  EXPECT_THROW(layout_faults(problem, *layout), Error);
}

TEST(PublicPacking, SaysWhatLimitItMet) {
  const PackProblem problem = dots_and_block();
  EXPECT_FALSE(pack(problem, {.threads = 1, .work = 1})->met.has_value());
  EXPECT_EQ(pack(problem, {.threads = 1, .seconds = 0.05})->met, Limit::kTime);
  EXPECT_EQ(pack(problem, {.threads = 1, .seconds = 60, .memory = 1})->met, Limit::kMemory);
  Options options{.seconds = 60};
  int told = 0;
  const auto best = pack(problem, options, [&](const PackLayout& layout) {
    EXPECT_EQ(layout.items.size(), 3u);
    ++told;
    options.cancel.request();
  });
  EXPECT_EQ(told, 1);
  EXPECT_EQ(best->met, Limit::kCancelled);
  options.cancel.reset();
  EXPECT_THROW(pack(problem, options, [](const PackLayout&) { throw Error(ErrorCode::kUsage, "enough"); }), Error);
}

TEST(PublicPacking, ANumberWithTooManyDigitsIsNamed) {
  PackProblem problem = dots_and_block();
  problem.gap = Number("1e40");
  try {
    pack(problem, {.threads = 1, .work = 1});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kOutOfRange);
    EXPECT_EQ(e.place(), "gap");
  }
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
  const auto layout = pack(problem, {.threads = 1, .work = 2});
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
  EXPECT_TRUE(pack(problem, {.threads = 1, .work = 1}).has_value());
}

TEST(PublicPacking, ShapesWithArcs) {
  PackProblem problem;
  problem.height = 8;
  problem.parts = {PackPart::of("disc", Shape::disc({0, 0}, 2), 6)};
  const auto layout = pack(problem, {.threads = 1, .work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->length.text(), "12");
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  EXPECT_NE(layout_svg(problem, *layout).find("A2 2 0 0 1"), std::string::npos);
  PackLayout nearer = *layout;
  nearer.items[0].x = std::stod(nearer.items[0].x.text()) + 1e-9;
  EXPECT_FALSE(layout_faults(problem, nearer).empty());
  problem.gap = "0.00001";
  EXPECT_FALSE(layout_faults(problem, *layout).empty());
}

TEST(PublicPacking, ShapesOfAllKinds) {
  PackProblem problem;
  problem.height = 6;
  const Shape plate = Shape::subtract({Shape::box({0, 0}, {6, 6}), Shape::disc({3, 3}, 2)});  // lacks its inner edge
  problem.parts = {PackPart::of("plate", plate), PackPart::of("peg", Shape::disc({0, 0}, 2)),
                   PackPart::of("tile", Shape::box({0, 0}, {2, 6}, {"0.25"}))};
  problem.parts[0].angles = {0, 45};
  const auto layout = pack(problem, {.threads = 1, .work = 4});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->length.text(), "8");  // the peg in the plate
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  problem.parts[0].rings = {box_ring(0, 0, 1, 1)};
  EXPECT_THROW(layout_faults(problem, *layout), Error);  // rings and a shape
  const auto refused = [&](Shape shape) {
    problem.parts = {PackPart::of("bad", std::move(shape))};
    EXPECT_THROW(pack(problem, {.threads = 1, .work = 1}), Error);
  };
  refused(Shape::polyline({{0, 0}, {3, 3}}));
  refused(Shape::unite({Shape::box({0, 0}, {1, 1}), Shape::polyline({{0, 0}, {3, 3}})}));
  refused(Shape::complement(Shape::box({0, 0}, {1, 1})));
  refused(Shape::box(Point3{0, 0, 0}, Point3{1, 1, 1}));
}

TEST(PublicPacking, ShapesOfJson) {
  const PackProblem problem =
      pack_problem(R"({"strip_height": 8, "shapes": {"peg": {"disc": {"center": [5, 5], "radius": 2}}},
    "items": [{"id": "peg", "demand": 2, "shape": "peg"},
              {"id": "slot", "demand": 1, "mirrored": true, "allowed_orientations": [0, 90],
               "shape": {"path": "M0 0 H4 A2 2 0 0 1 4 4 H0 Z"}},
              {"id": "plain", "demand": 1, "shape": {"polygon": [[0, 0], [4, 0], [4, 1.25]]}}]})");
  ASSERT_EQ(problem.parts.size(), 3u);
  ASSERT_TRUE(problem.parts[0].shape.has_value());
  const auto layout = pack(problem, {.threads = 1, .work = 4});
  ASSERT_TRUE(layout.has_value());
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  try {
    pack_problem(R"({"strip_height": 8, "items": [{"id": "peg", "demand": 2, "shape": "peg"}]})");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(e.place().find("problem:1:"), std::string::npos) << e.what();
  }
}

TEST(PublicPacking, WhatTheLastSheetHasLeft) {
  PackProblem problem;
  problem.sheets = {PackSheet::rectangle("plate", 10, 6, 3)};
  problem.parts = {{"box", {box_ring(0, 0, 4, 5)}, 3}};
  const auto layout = pack(problem, {.threads = 1, .work = 2});
  ASSERT_TRUE(layout.has_value() && layout->remnant.has_value());
  EXPECT_EQ(layout->remnant->sheet, 1u);
  EXPECT_EQ(layout->remnant->width.text(), "6");
  EXPECT_EQ(layout->remnant->height.text(), "6");
  EXPECT_NE(layout_json(problem, *layout).find("\"remnant\": {\"sheet\": 1"), std::string::npos);
}

TEST(PublicPacking, AFixedPartStandsAtItsAngle) {
  PackProblem problem = dots_and_block();
  problem.fixed = {{.part = "a", .x = 6, .y = 1, .angle = 45}};
  const auto layout = pack(problem, {.threads = 1, .work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_NEAR(std::stod(layout->length.text()), 6 + std::sqrt(0.5), 1e-5);  // not on the grid of whole numbers
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  problem.fixed[0].y = 3;
  EXPECT_THROW(pack(problem, {.threads = 1, .work = 1}), Error);  // it reaches beyond the strip
}

TEST(PublicPacking, AZoneHoldsOrKeepsOut) {
  PackProblem problem = dots_and_block();
  problem.sheets = {PackSheet::rectangle("plate", 9, 4)};
  problem.sheets[0].zones = {{{box_ring(5, 0, 9, 4)}, {}, {"block"}}};
  const auto layout = pack(problem, {.threads = 1, .work = 2});
  ASSERT_TRUE(layout.has_value());
  ASSERT_EQ(layout->items.size(), 3u);
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  EXPECT_EQ(layout->length.text(), "9");  // the block lies in the zone
  problem.sheets[0].zones[0].keeps_out = {"a"};
  EXPECT_THROW(pack(problem, {.threads = 1, .work = 1}), Error);
}

TEST(PublicPacking, ADiscFillsItsRoundSheet) {
  PackProblem problem;
  problem.sheets = {{"blank", {}, 1}};
  problem.sheets[0].shape = Shape::subtract({Shape::disc({5, 5}, 5), Shape::disc({5, 5}, 1)});
  problem.parts = {PackPart::of("ring", Shape::subtract({Shape::disc({0, 0}, 5), Shape::disc({0, 0}, "0.75")}))};
  EXPECT_TRUE(pack(problem, {.threads = 1, .work = 1}).value().items.empty());  // the hole of the sheet is wider
  problem.sheets[0].shape = Shape::subtract({Shape::disc({5, 5}, 5), Shape::disc({5, 5}, "0.75")});
  auto layout = pack(problem, {.threads = 1, .work = 1});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->items[0].x.text(), "5");
  EXPECT_EQ(layout->items[0].y.text(), "5");
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  layout->items[0].y = "5.000001";
  EXPECT_FALSE(layout_faults(problem, *layout).empty());
  problem.sheets[0].shape = Shape::disc({5, 6}, 5);
  EXPECT_THROW(pack(problem, {.threads = 1, .work = 1}), Error);  // its box does not begin at (0, 0)
  problem.sheets[0].rings = {box_ring(0, 0, 4, 5)};
  EXPECT_THROW(pack(problem, {.threads = 1, .work = 1}), Error);  // both
}

TEST(PublicPacking, AProblemIsPutOnItsGridOnce) {
  const PackProblem problem = dots_and_block();
  const Packing packing(problem);
  EXPECT_EQ(packing.copies(), 3u);
  EXPECT_EQ(packing.lower_bound().text(), "4.5");
  EXPECT_EQ(packing.problem().parts[2].name, "block");
  int better = 0, progress = 0;
  PackSearch<PackLayout> search;
  search.better = [&](const PackLayout& layout, const PackProgress& state) {
    ++better;
    EXPECT_EQ(layout.length.value(), state.length);
    EXPECT_EQ(layout.density, state.density);
  };
  search.progress = [&](const PackProgress&) { ++progress; };
  const auto layout = packing.search({.threads = 1, .seed = 7, .work = 2}, search);
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->length.text(), "5");
  EXPECT_EQ(layout->seed, 7u);
  EXPECT_GE(better, 1);
  EXPECT_GE(progress, 1);
  EXPECT_TRUE(packing.verdict(*layout).feasible());
  EXPECT_EQ(packing.verdict(*layout).used.text(), "5");
  const PackLayout back = packing.layout(packing.json(*layout));
  EXPECT_EQ(back.items[0].x.text(), layout->items[0].x.text());
  EXPECT_NE(packing.json(*layout).find("\"seed\": 7"), std::string::npos);
  EXPECT_NE(packing.dxf(*layout, DxfVersion::k2000).find("AC1015"), std::string::npos);
  EXPECT_EQ(packing.outline(0)[0], 'M');
  EXPECT_THROW(packing.outline(3), Error);
  search.start = *layout;
  const auto again = packing.search({.threads = 1, .work = 1}, search);
  EXPECT_EQ(again->length.text(), "5");
  search.start->items.pop_back();
  EXPECT_THROW(packing.search({.threads = 1, .work = 1}, search), Error);  // a copy is not accounted for
}

TEST(PublicPacking, FaultsSayWhatIsWrong) {
  const Packing packing(dots_and_block());
  PackLayout layout = *packing.search({.threads = 1, .work = 2});
  for (PlacedPart& item : layout.items) item.x = 0, item.y = 0;
  layout.items.pop_back();
  const PackVerdict verdict = packing.verdict(layout);
  ASSERT_EQ(verdict.faults.size(), 2u);
  const auto with = [&](PackFault::Kind kind) {
    for (const PackFault& fault : verdict.faults)
      if (fault.kind == kind) return fault;
    return PackFault{};
  };
  EXPECT_EQ(with(PackFault::Kind::kOverlap).of.size(), 2u);
  EXPECT_EQ(with(PackFault::Kind::kOverlap).depth, 1);
  EXPECT_EQ(with(PackFault::Kind::kCount).of.size(), 1u);
  EXPECT_EQ(with(PackFault::Kind::kCount).depth, -1);
}

TEST(PublicPacking, TheOthersMakeRoomForAnItem) {
  const Packing packing(dots_and_block());
  const PackLayout layout = *packing.search({.threads = 1, .work = 2});
  const auto moved = packing.moved(layout, 0, {2, 1});
  ASSERT_TRUE(moved.has_value());
  EXPECT_TRUE(packing.verdict(*moved).feasible());
  EXPECT_THROW(packing.moved(layout, 3, {0, 0}), Error);
  try {
    packing.moved({}, 0, {0, 0});
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "the layout has no items");
  }
}

TEST(PublicPacking, OnSheetsTheOthersMakeRoomAsWell) {
  PackProblem problem;
  problem.sheets = {PackSheet::rectangle("sheet", 9, 9, 2)};
  problem.sheets[0].zones = {{{box_ring(0, 0, 1, 9)}, {"tile"}}};
  problem.parts = {{"tile", {box_ring(0, 0, 3, 3)}, 4}};
  const Packing packing(problem);
  PackLayout layout;
  layout.sheets = {"sheet", "sheet"};
  layout.items = {{"tile", 1, 0, 0, false, 1, 0},
                  {"tile", 2, 0, 0, false, 4, 0},
                  {"tile", 3, 0, 0, false, 1, 3},
                  {"tile", 4, 1, 0, false, 5, 5}};
  ASSERT_TRUE(packing.verdict(layout).feasible());
  // Where it is free it stands, and nothing else moves.
  const auto free = packing.moved(layout, 0, {5, 5});
  ASSERT_TRUE(free.has_value());
  EXPECT_EQ(free->items[0].x, Number(5));
  EXPECT_EQ(free->items[0].y, Number(5));
  EXPECT_EQ(free->items[1].x, Number(4));
  // Upon another, in the zone and over the sheet's corner.
  for (const Position at : {Position{4, 1}, Position{0, 5}, Position{8, 8}}) {
    const auto made = packing.moved(layout, 0, at);
    ASSERT_TRUE(made.has_value());
    EXPECT_TRUE(packing.verdict(*made).feasible());
    EXPECT_EQ(made->sheets, layout.sheets);
    EXPECT_EQ(made->items.size(), 4u);
  }
  EXPECT_EQ(packing.sheet_outline(0), "M0,-0L9,-0L9,-9L0,-9z");
  EXPECT_EQ(packing.sheet_zones(0), "M0,-0L1,-0L1,-9L0,-9z");
  EXPECT_THROW(packing.sheet_outline(1), Error);
}

TEST(PublicPacking, OnAFullSheetTheyChangePlacesOrHaveNoRoom) {
  PackProblem problem;
  problem.sheets = {PackSheet::rectangle("sheet", 5, 3)};
  problem.parts = {{"tile", {box_ring(0, 0, 3, 3)}, 1}, {"bar", {box_ring(0, 0, 2, 3)}, 1}};
  PackLayout layout;
  layout.sheets = {"sheet"};
  layout.items = {{"tile", 1, 0, 0, false, 0, 0}, {"bar", 1, 0, 0, false, 3, 0}};
  const Packing packing(problem);
  const auto made = packing.moved(layout, 1, {0, 0});
  ASSERT_TRUE(made.has_value());
  EXPECT_TRUE(packing.verdict(*made).feasible());
  EXPECT_EQ(made->items[0].x, Number(2));
  problem.fixed = {{"tile", 0, 0, 0, false, "sheet"}};
  EXPECT_THROW(Packing(problem).moved(layout, 0, {2, 0}), Error);
  problem.fixed = {{"tile", 1, 0, 0, false, "sheet"}};
  layout.items[0].x = 1;
  EXPECT_FALSE(Packing(problem).moved(layout, 1, {0, 0}).has_value());
}

TEST(PublicPacking, APartThatFitsNowhereIsNotMoved) {
  PackProblem problem;
  problem.sheets = {PackSheet::rectangle("sheet", 5, 3)};
  problem.parts = {{"long", {box_ring(0, 0, 6, 1)}, 1}, {"bar", {box_ring(0, 0, 2, 3)}, 1}};
  PackLayout layout;
  layout.sheets = {"sheet"};
  layout.items = {{"long", 1, 0, 0, false, 0, 0}, {"bar", 1, 0, 0, false, 3, 0}};
  EXPECT_FALSE(Packing(problem).moved(layout, 0, {0, 1}).has_value());
}

TEST(PublicPacking, ABoxGrowsWhereThatMakesRoom) {
  PackProblem problem;
  problem.box = true;
  problem.parts = {{"tile", {box_ring(0, 0, 3, 3)}, 2}};
  PackLayout layout;
  layout.length = 6;
  layout.height = 3;
  layout.items = {{"tile", 1, 0, 0, false, 0, 0}, {"tile", 2, 0, 0, false, 3, 0}};
  const Packing packing(problem);
  const auto made = packing.moved(layout, 0, {1.5, 0});
  ASSERT_TRUE(made.has_value());
  EXPECT_TRUE(packing.verdict(*made).feasible());
  EXPECT_EQ(made->height, Number(3));
}

/// The message of the error, or nothing.
template <class Ask>
std::string refusal(const Ask& ask) {
  try {
    ask();
    return "";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kBadValue);
    return e.what();
  }
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

TEST(PublicPacking, ALayoutToStartWithIsOneOfTheProblem) {
  PackProblem problem;
  problem.sheets = {PackSheet::rectangle("plate", 4, 4)};
  problem.parts = {{"tile", {box_ring(0, 0, 2, 2)}, 2}};
  PackLayout start;
  start.sheets = {"plate"};
  start.items = {{"tile", 1, 0, 0, false, 0, 0}, {"tile", 2, 0, 0, false, 2, 0}};
  const auto said = [&] {
    PackSearch<PackLayout> how;
    how.start = start;
    const Packing packing(problem);
    const std::string of_moved = refusal([&] { packing.moved(start, start.items.size() - 1, {0, 0}); });
    EXPECT_EQ(refusal([&] { packing.search({.threads = 1, .work = 1}, how); }), of_moved);
    EXPECT_EQ(refusal([&] { packing.check_start(start); }), of_moved);
    return of_moved;
  };
  EXPECT_EQ(said(), "");
  start.items[1].sheet = 1;
  EXPECT_TRUE(contains(said(), "has tile#2 on sheet 1, which it does not list"));
  start.sheets.push_back("plate");
  EXPECT_TRUE(contains(said(), "uses more sheets 'plate' than there are"));
  start.sheets.pop_back();
  start.items[1].sheet = 0;
  problem.fixed = {{.part = "tile", .x = 1, .y = 1, .sheet = "plate"}};
  EXPECT_TRUE(contains(said(), "lacks the fixed part 'tile' at (1, 1)"));
  problem.fixed[0] = {.part = "tile", .x = 0, .y = 0, .sheet = "plate"};
  EXPECT_EQ(said(), "");
  start.items.pop_back();
  EXPECT_TRUE(contains(said(), "has other parts than the problem"));
  problem.sheets.clear();
  problem.fixed.clear();
  problem.height = 4;
  start.sheets.clear();
  start.items.push_back({"tile", 2, 1, 0, false, 2, 0});
  EXPECT_TRUE(contains(said(), "on sheet 1"));
}

/// With another gap, height or angle it is no longer feasible.
TEST(PublicPacking, ALayoutToStartWithNeedNotBeFeasible) {
  PackProblem problem;
  problem.height = 4;
  problem.parts = {{"tile", {box_ring(0, 0, 2, 2)}, 4}};
  PackSearch<PackLayout> how;
  how.start.emplace();
  for (int k = 0; k < 4; ++k) how.start->items.push_back({"tile", k + 1, 0, k * 45, false, k / 2 * 2, k % 2 * 2});
  how.start->length = 4;
  const auto searched = [&] {
    const auto layout = Packing(problem).search({.threads = 1, .work = 1}, how);
    EXPECT_TRUE(layout && layout_faults(problem, *layout).empty());
    return *layout;
  };
  EXPECT_EQ(searched().length, Number(4));
  problem.gap = 1;
  EXPECT_NEAR(searched().length.value(), 11, 1e-3);
  problem.height = 6;
  EXPECT_NEAR(searched().length.value(), 5, 1e-3);
  how.start->items.pop_back();
  how.start->left_out = {{"tile", 1, ""}};
  EXPECT_TRUE(searched().left_out.empty());
  problem.sheets = {PackSheet::rectangle("plate", 5, 5, 2)};
  how.start->sheets = {"plate"};
  how.start->items[2].x = 1;
  EXPECT_TRUE(searched().left_out.empty());
  problem.gap = 2;  // one a sheet
  EXPECT_EQ(searched().items.size(), 2u);
}

TEST(PublicPacking, AnItemIsMovedFarOnAFineGrid) {
  PackProblem problem;
  problem.sheets = {PackSheet::rectangle("sheet", 3000, 2)};
  problem.parts = {{"tile", {{{0, 0}, {1, 0}, {"1.0000000000000001", 1}, {0, 1}}}}};
  PackLayout layout;
  layout.sheets = {"sheet"};
  layout.items = {{"tile", 1, 0, 0, false, 0, 0}};
  const Packing packing(problem);
  const auto moved = packing.moved(layout, 0, {2000, 0});
  ASSERT_TRUE(moved.has_value());
  EXPECT_EQ(moved->items[0].x, Number(2000));
  EXPECT_THROW(packing.moved(layout, 0, {1e300, 0}), Error);
}

/// A defect that is marked twice is missing once; so is what of it lies on the sheet.
TEST(PublicPacking, HolesMayOverlap) {
  PackProblem problem;
  problem.sheets = {{"plate", {box_ring(0, 0, 10, 10), box_ring(3, 3, 7, 8), box_ring(3, 3, 7, 8)}, 2}};
  problem.parts = {{"dot", {box_ring(0, 0, 1, 1)}, 68}};
  EXPECT_EQ(Packing(problem).lower_bound(), Number(1));
  problem.sheets[0].rings[2] = box_ring(5, 5, 8, 8);
  EXPECT_EQ(Packing(problem).lower_bound(), Number(1));
  problem.parts[0].count = 78;  // one more than there is room for
  EXPECT_EQ(Packing(problem).lower_bound(), Number(2));
  problem.sheets[0].rings = {box_ring(0, 0, 10, 10), box_ring(8, 0, 12, 10)};
  EXPECT_EQ(Packing(problem).lower_bound(), Number(1));
  problem.parts[0].count = 1;
  const auto layout = pack(problem, {.threads = 1, .work = 1});
  ASSERT_TRUE(layout.has_value());
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  problem.sheets[0].rings = {box_ring(0, 0, 10, 10), box_ring(-1, -1, 12, 12)};
  EXPECT_THROW(Packing{problem}, Error);  // nothing is left
}

/// Between holes that touch along an edge, or a hole and the outline, there is no wall: a block lies across.
TEST(PublicPacking, HolesThatTouchLeaveNoWall) {
  const auto holes_hold = [](std::vector<Ring> holes, Ring block) {
    PackProblem problem;
    problem.height = 10;
    holes.insert(holes.begin(), box_ring(0, 0, 10, 10));
    problem.parts = {{"plate", std::move(holes)}, {"block", {std::move(block)}}};
    const auto layout = pack(problem, {.threads = 1, .work = 1});
    return layout && layout_faults(problem, *layout).empty() && layout->length.text() == "10";
  };
  EXPECT_TRUE(holes_hold({box_ring(2, 2, 5, 8), box_ring(5, 3, 8, 9)}, box_ring(0, 0, 6, 5)));
  EXPECT_TRUE(holes_hold({box_ring(2, 0, 8, 8)}, box_ring(0, 0, 6, 8)));
  EXPECT_TRUE(holes_hold({box_ring(2, 2, 5, 8), box_ring(5, 2, 8, 8), box_ring(3, 8, 7, 10)}, box_ring(0, 0, 4, 8)));
  EXPECT_FALSE(holes_hold({box_ring(2, 2, 4, 8), box_ring(5, 2, 8, 8)}, box_ring(0, 0, 6, 6)));
}

/// Turned parts have corners off the grid of the numbers. With conditions the grid stays coarse enough for them.
TEST(PublicPacking, ConditionsOfLongParts) {
  PackProblem problem;
  problem.height = 40;
  problem.parts = {{"bar", {{{0, 0}, {1200, 0}, {1200, 10}, {0, "10.125"}}}, 2, {0, 45}}};
  problem.where = "gap(self, other) >= 5";
  PackLayout layout;
  layout.length = 1200;
  layout.items = {{"bar", 1, 0, 0, false, 0, 0}, {"bar", 2, 0, 0, false, 0, 20}};
  EXPECT_TRUE(layout_faults(problem, layout).empty());
  layout.items[1].y = 15;
  EXPECT_FALSE(layout_faults(problem, layout).empty());
}

TEST(PublicPacking, JsonIsReadAsItIsAsked) {
  const char* const text = R"({"name": "kit", "strip_height": 4, "unread": 1,
    "items": [{"id": "a", "demand": 2, "shape": {"type": "simple_polygon", "data": [[0,0], [1,0], [1,1.5]]}}]})";
  PackReading reading;
  reading.height = 3;
  reading.gap = "0.5";
  const Packing packing = Packing::json(text, reading);
  EXPECT_EQ(packing.problem().height.text(), "3");
  EXPECT_EQ(packing.problem().gap.text(), "0.5");
  EXPECT_EQ(packing.notes().size(), 1u);
  reading.name = "kit.json";
  try {
    Packing::json("{", reading);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kSyntax);
    EXPECT_EQ(e.place().rfind("kit.json", 0), 0u);
  }
}

TEST(PublicPacking, ATokenEndsTheSearch) {
  const Packing packing(dots_and_block());
  Options options{.threads = 1};
  PackSearch<PackLayout> search;
  search.progress = [&](const PackProgress&) { options.cancel.request(); };
  const auto layout = packing.search(options, search);  // without limits else for half a minute
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->met, Limit::kCancelled);
}

}  // namespace io_public_packing
