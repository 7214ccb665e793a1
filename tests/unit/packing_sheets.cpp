// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sheets: walls, outlines, holes and zones, mirrored parts, gaps of pairs, and the most valuable choice of parts.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <atomic>

#include "packing/nfp/row.h"
#include "packing/proof/remnant.h"
#include "packing/proof/verify.h"
#include "packing/search/box_search.h"
#include "packing_found.h"

namespace findspace::packing {
namespace packing_sheets {

Ring box_ring(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Polygon box(int w, int h) { return make_polygon({box_ring(0, 0, w, h)}, "box"); }

TEST(Sheets, BoxesThatFillThem) {
  Problem problem;
  problem.sheets.push_back({"plate", 9, {}, box(6, 4)});
  problem.parts = {{"domino", 12, box(1, 2), {0, 90}}, {"square", 12, box(2, 2), {0}}};
  const Layout layout = found(problem, 3e7);  // 72 units of area on plates of 24
  EXPECT_EQ(layout.sheets.size(), 3u);
  EXPECT_TRUE(layout.left_out.empty());
  EXPECT_DOUBLE_EQ(container_area(problem, layout), area(problem));
}

TEST(Sheets, NoPartLiesAcrossAWall) {
  Problem problem;
  problem.sheets.push_back({"plate", 3, {}, box(5, 5)});
  problem.parts = {{"big", 3, box(3, 3), {0}}};
  const Layout layout = found(problem, 4e6);
  EXPECT_EQ(layout.sheets.size(), 3u);
  EXPECT_EQ(layout.length, Fraction(3));
}

/// As many tenths as a sheet, a strip or a box have; in doubles some of these sizes come out larger than others.
TEST(Sheets, PartsWithoutClearanceInTenths) {
  for (int size = 1; size < 40; ++size) {
    Problem problem;
    problem.digits = 1;
    problem.parts = {{"part", 2, make_polygon({box_ring(13, 7, 13 + size, 7 + size)}, "part"), {0}}};
    problem.height = Fraction(size, 10);
    EXPECT_EQ(found(problem, 1e3).length, Fraction(2 * size, 10)) << size;
    problem.edge = Fraction(2, 10);
    problem.sheets.push_back({"plate", 2, {}, box(size + 4, size + 4)});
    EXPECT_TRUE(found(problem, 1e3).left_out.empty()) << size;
    problem.parts[0].shape = make_polygon({box_ring(13, 7, 13 + size, 8 + size)}, "higher");
    const std::atomic<bool> stop = false;
    EXPECT_FALSE(search_strip(problem, {}, {}, stop).has_value()) << size;
    problem.sheets.clear();
    problem.edge = 0;
    EXPECT_THROW(FieldTable{problem}, Error) << size;
  }
}

TEST(Sheets, PartsThatFitSomeSheetsAlone) {
  Problem problem;
  problem.sheets.push_back({"low", 2, {}, box(20, 5)});
  problem.sheets.push_back({"narrow", 2, {}, box(9, 20)});
  problem.sheets.push_back({"high", 2, {}, box(12, 12)});
  problem.parts = {{"big", 2, box(10, 10), {0}}};
  const Layout layout = found(problem, 1e4);
  EXPECT_EQ(layout.sheets, (std::vector<std::size_t>{2, 2}));
}

TEST(Sheets, OutlineHoleAndZone) {
  Problem problem;
  // An L of two squares of 4 and a corner, with a hole of 2 in the corner; squares of 4 have two places.
  Polygon angle = make_polygon({{{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, {0, 8}}, box_ring(1, 1, 3, 3)}, "angle");
  problem.sheets.push_back({"angle", 1, {}, angle});
  Layout cut;
  cut.sheets = {0};
  cut.length = Fraction(6);
  EXPECT_DOUBLE_EQ(container_area(problem, cut), 4 * 8 + 2 * 4 - 2 * 2);  // what lies left of x = 6
  problem.parts = {{"square", 2, box(4, 4), {0}}, {"dot", 1, box(1, 1), {0}}};
  const Layout layout = found(problem, 4e6);
  EXPECT_TRUE(layout.left_out.empty());
  problem.sheets[0].zones.push_back({make_polygon({box_ring(4, 0, 5, 1)}, "zone"), {0}});
  const Layout kept_out = found(problem, 4e6);
  ASSERT_EQ(kept_out.left_out.size(), 1u);
  EXPECT_EQ(kept_out.left_out[0].copies, 1);
  Layout wrong = layout;
  EXPECT_EQ(verify(problem, wrong).faults.at(0).kind, Fault::Kind::kZone);
  wrong = kept_out;
  wrong.items[0].x = Fraction(1);
  EXPECT_FALSE(verify(problem, wrong).feasible());
}

/// Bars as long as the sheet but one: side by side along its lower side they leave most of it as one rectangle.
TEST(Sheets, TheLastLeavesALargeRectangle) {
  Problem problem;
  problem.sheets.push_back({"plate", 2, {}, box(10, 10)});
  problem.parts = {{"bar", 3, box(9, 1), {0}}, {"plug", 1, box(1, 2), {0}}};
  for (const char* where : {"gap(self, other) >= 0", "gap(self, other, along=(0, 1)) <= 5"}) {
    problem.conditions = {{0, 0, where}};
    const Layout layout = found(problem, 1e8);
    EXPECT_EQ(layout.sheets.size(), 1u) << where;
    const Remnant left = largest_remnant(problem, layout).value();
    EXPECT_EQ(left.width, Fraction(10)) << where;
    EXPECT_EQ(left.height, Fraction(7)) << where;
  }
}

TEST(Sheets, TheLastOneMayBeAnyShapeWithHolesZonesAndFixedParts) {
  Problem problem;
  Polygon angle = make_polygon({{{0, 0}, {12, 0}, {12, 9}, {0, 6}}, box_ring(5, 1, 6, 2)}, "angle");
  problem.sheets.push_back({"angle", 1, {}, angle, {{make_polygon({box_ring(0, 0, 2, 1)}, "zone"), {0}}}});
  problem.parts = {{"bar", 3, box(4, 1), {0, 90}, true}, {"post", 2, box(1, 1), {0}}};
  problem.fixed = {{{.part = 1, .copy = 1, .angle = 0, .mirrored = false, .x = 3, .y = 3}, 0}};
  const Layout layout = found(problem, 5e7);
  EXPECT_EQ(layout.items.size(), 5u);
  EXPECT_TRUE(layout.left_out.empty());
}

TEST(Sheets, TheMostValuableChoice) {
  Problem problem;
  problem.sheets.push_back({"plate", 1, {}, box(4, 4)});
  problem.parts = {{"cheap", 1, box(4, 4), {0}}, {"dear", 4, box(2, 2), {0}}, {"huge", 1, box(9, 9), {0}}};
  problem.parts[0].value = 1;
  problem.parts[1].value = 1;
  const Layout layout = found(problem, 2e7);
  ASSERT_EQ(layout.items.size(), 4u);
  for (const Placed& item : layout.items) EXPECT_EQ(item.part, 1u);
  EXPECT_EQ(layout.left_out.size(), 2u);
}

TEST(Sheets, TooManyOfAKind) {
  Problem problem;
  problem.sheets.push_back({"plate", 1, {}, box(4, 4)});
  problem.parts = {{"square", 2, box(2, 2), {0}}};
  Layout layout{2, {{0, 1, 0, false, 0, 0, 0}, {0, 2, 0, false, 0, 0, 1}}, {}, {0, 0}};
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kSheets);
  layout.sheets = {0};
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kOutside);
}

TEST(Sheets, TheDensityIsThatOfWhatIsUsed) {
  Problem problem;
  problem.sheets.push_back({"plate", 1, {}, box(10, 10)});
  problem.parts = {{"square", 1, box(4, 4), {0}}};
  const Layout layout{1, {{0, 1, 0, false, 4, 0, 0}}, {}, {0}};  // 8 are used, not 1
  EXPECT_DOUBLE_EQ(verify(problem, layout).density, 0.2);
}

TEST(Strip, AFixedPartStandsAtItsAngleHoweverThatIsWritten) {
  Problem problem;
  problem.height = 10;
  problem.parts = {{"corner", 1, make_polygon({{{0, 0}, {2, 0}, {0, 2}}}, "corner"), {0}}};
  problem.fixed = {{{.part = 0, .copy = 1, .angle = 90, .mirrored = false, .x = 2, .y = 0}, 0}};
  EXPECT_TRUE(verify(problem, {2, {{0, 1, -270, false, 2, 0}}}).feasible());
  EXPECT_FALSE(verify(problem, {2, {{0, 1, -90, false, 2, 0}}}).feasible());
}

/// An item of a strip stands on it, and not beside it on another sheet.
TEST(Strip, IsOneSheet) {
  Problem problem;
  problem.height = 4;
  problem.parts = {{"square", 2, box(2, 2), {0}}};
  const Layout layout{4, {{0, 1, 0, false, 0, 0, 0}, {0, 2, 0, false, 1, 1, 1}}, {}};
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kOutside);
}

TEST(Strip, AMirroredPartFits) {
  Problem problem;
  problem.height = 2;
  const Polygon half = make_polygon({{{0, 0}, {3, 0}, {0, 2}}}, "half");
  problem.parts = {{"a", 1, half, {0, 180}}, {"b", 1, rotated(half, 0, true), {0, 180}, true}};
  EXPECT_EQ(found(problem, 2e7).length, Fraction(3));
  problem.parts[1].mirrored = false;
  EXPECT_GT(found(problem, 2e7).length, Fraction(3));
}

TEST(Strip, AGapOfAPair) {
  Problem problem;
  problem.digits = 3;
  problem.height = 2;
  problem.parts = {{"a", 1, box(2000, 2000), {0}}, {"b", 1, box(2000, 2000), {0}}, {"c", 1, box(2000, 2000), {0}}};
  problem.pair_gaps.push_back({0, 1, Fraction(2)});
  EXPECT_EQ(found(problem, 1e7).length, Fraction(6));  // c lies between them
}

TEST(Box, OfTheLeastArea) {
  Problem problem;
  problem.box = true;
  problem.parts = {{"domino", 8, box(1, 2), {0, 90}}, {"square", 2, box(2, 2), {0}}};
  const std::atomic<bool> stop = false;
  SearchOptions options;
  options.work = 2e7;
  const auto layout = search_box(problem, options, {}, stop);
  ASSERT_TRUE(layout.has_value());
  EXPECT_TRUE(verify(problem, *layout).feasible());
  EXPECT_DOUBLE_EQ(container_area(problem, *layout), 24);
}

TEST(Box, OfOnePartInTenths) {
  Problem problem;
  problem.digits = 1;
  problem.box = true;
  problem.parts = {{"bar", 1, box(10, 3), {0}}};
  const std::atomic<bool> stop = false;
  SearchOptions options;
  options.work = 1e4;
  const auto layout = search_box(problem, options, {}, stop);
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->height, Fraction(3, 10));
}

TEST(Box, BeginsWithALayout) {
  Problem problem;
  problem.box = true;
  problem.parts = {{"domino", 2, box(1, 2), {0, 90}}};
  Layout start{9, {{0, 1, 0, false, 0, 0}, {0, 2, 0, false, 1, 0}}, {}};
  start.height = 7;
  const std::atomic<bool> stop = true;
  SearchOptions options;
  options.start = &start;
  const auto layout = search_box(problem, options, {}, stop);
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->items.size(), 2u);
  EXPECT_EQ(layout->length, Fraction(2));
  EXPECT_EQ(layout->height, Fraction(2));
  start.items[1].x = 0;  // upon each other
  const auto other = search_box(problem, options, {}, stop);
  EXPECT_TRUE(!other || verify(problem, *other).feasible());
}

/// No corner of what keeps the part away leaves it room: only where the sides of two no-fit polygons cross.
TEST(Sheets, APlaceThatIsNoCorner) {
  Problem problem;
  problem.digits = 1;
  const Polygon slits = make_polygon({{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                      {{5, 40}, {10, 40}, {10, 60}, {5, 60}},
                                      {{50, 1}, {60, 1}, {60, 5}, {50, 5}}},
                                     "slits");
  problem.sheets.push_back({"plate", 1, {}, slits});
  problem.parts = {{"block", 1, box(60, 90), {0}}};
  const Layout layout = found(problem, 1e6);
  EXPECT_EQ(layout.items.size(), 1u);
  problem.parts = {{"block", 2, box(60, 90), {0}}, {"dot", 1, box(4, 4), {0}}};
  problem.fixed = {{{.part = 1, .copy = 1, .angle = 0, .mirrored = false, .x = 0, .y = 0}, 0}};
  EXPECT_EQ(found(problem, 1e6).items.size(), 2u);
  problem.fixed.clear();
  problem.parts = {{"block", 1, box(95, 95), {0}}};  // smaller than the sheet, and there is no place for it
  const Layout none = found(problem, 1e6);
  EXPECT_TRUE(none.items.empty());
  EXPECT_EQ(none.left_out.at(0).why, "no container was found for it");
}

/// Fixed copies may look as free ones do.
TEST(FieldTable, PairsThatShareAField) {
  Problem problem;
  problem.height = 20;
  const Polygon corner = make_polygon({{{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}}}, "corner");
  const Polygon wedge = make_polygon({{{2, 1}, {6, 0}, {3, 5}}}, "wedge");
  problem.parts = {{"corner", 2, corner, {0, 90, 180, 270}}, {"wedge", 2, wedge, {0, 180}, true}};
  problem.fixed = {{{.part = 0, .copy = 1, .angle = 180, .mirrored = false, .x = 9, .y = 9}, 0},
                   {{.part = 1, .copy = 1, .angle = 0, .mirrored = false, .x = 9, .y = 9}, 0}};
  const FieldTable table(problem);
  const std::size_t n = table.variants().size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      const DepthField own(no_fit_polygon(table.variants()[a].shape, table.variants()[b].shape, 0));
      for (int i = -30; i < 30; ++i)
        for (int j = -30; j < 30; ++j) {
          const Vec at{0.37 * i, 0.41 * j};
          EXPECT_NEAR(table.depth({a, {1, 2}}, {b, Vec{1, 2} + at}), own.depth(at), 1e-9);
        }
    }
}

}  // namespace packing_sheets
}  // namespace findspace::packing
