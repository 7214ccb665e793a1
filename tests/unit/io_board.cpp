// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boards of KiCad: malformed files first, then outlines, pads, what stands in for courtyards, and the copy of a file.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "findspace/error.h"
#include "io/board/board_scene.h"
#include "io/board/read_board.h"
#include "io/board/write_board.h"
#include "io/text/outline_shapes.h"
#include "plane/build/build.h"
#include "plane/query/summary.h"

namespace findspace::io {
namespace io_board {

constexpr const char* kOutline = "(gr_rect (start 0 0) (end 10 10) (layer \"Edge.Cuts\"))";

std::string board(const std::string& items, const std::string& version = "20211014") {
  return "(kicad_pcb (version " + version + ")\n (layers (0 \"F.Cu\" signal))\n" + items + ")\n";
}

std::string part(const std::string& name, const std::string& items, const std::string& at = "5 5") {
  return "(footprint \"F\" (layer \"F.Cu\") (at " + at + ")\n (fp_text reference \"" + name + "\" (at 0 0))\n" + items +
         ")\n";
}

void expect_refused(const std::string& text, const std::string& words, const std::string& place = "b.kicad_pcb") {
  try {
    read_board(text, "b.kicad_pcb");
    ADD_FAILURE() << "read, expected: " << words;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find(place), std::string::npos) << e.what();
  }
}

double area(const plane::ShapePtr& shape) {
  const plane::Region region = plane::build(*shape, 1e-6).region;
  return *plane::summarize(region, exact::Real::ratio(1, 1000000)).area;
}

TEST(ReadBoard, RefusesBrokenFiles) {
  expect_refused("", "a list in parentheses is meant", "b.kicad_pcb:1:1");
  expect_refused("(kicad_pcb\n (version 20211014)", "this '(' is not closed", "b.kicad_pcb:1:1");
  expect_refused("(kicad_pcb (a \"b)", "a quoted text that does not end", "b.kicad_pcb:1:15");
  expect_refused(board(kOutline) + ")", "nothing may stand after", "b.kicad_pcb:4:1");
  expect_refused("(a (version 1))", "a board of KiCad is meant");
  expect_refused(board(kOutline, "4"), "KiCad 4 or older");
  expect_refused(std::string(300, '('), "nested more than 200 deep", "b.kicad_pcb:1:201");
  expect_refused(board("(gr_line (start 0 0) (layer \"Edge.Cuts\"))"), "without (end ...) in it", "b.kicad_pcb:3:1");
  expect_refused(board("(gr_line (start 0 x) (end 1 1) (layer \"Edge.Cuts\"))"), "", "b.kicad_pcb:3:19");
}

TEST(ReadBoard, RefusesOutlines) {
  expect_refused(board(""), "the board has no outline");
  expect_refused(board("(gr_line (start 0 0) (end 5 0) (layer \"Edge.Cuts\"))"), "it is open at (0, 0)");
  expect_refused(board(std::string(kOutline) + "(gr_circle (center 30 30) (end 35 30) (layer \"Edge.Cuts\"))"),
                 "2 separate pieces");
  // Shorter than the gap that is joined; an arc that goes nearly round is closed.
  expect_refused(board("(gr_arc (start 5 5) (end 5 3) (angle 0.1) (layer \"Edge.Cuts\"))"), "it is open at (5, 3)");
  EXPECT_NEAR(
      area(read_board(board("(gr_arc (start 5 5) (end 5 3) (angle 359.9) (layer \"Edge.Cuts\"))"), "b").outline),
      4 * std::acos(-1.0), 0.01);
  EXPECT_NEAR(
      area(read_board(board("(gr_arc (start 5 3) (mid 5 7) (end 4.997 3) (layer \"Edge.Cuts\"))"), "b").outline),
      4 * std::acos(-1.0), 0.01);
  expect_refused(board("(gr_line (start 5 5) (end 5 5.001) (layer \"Edge.Cuts\"))"), "it is open at (5, 5");
  expect_refused(board("(gr_curve (pts (xy 0 0) (xy 1 0) (xy 1 1)) (layer \"Edge.Cuts\"))"), "four control points",
                 "b.kicad_pcb:3:1");
}

/// A part with an id, of 1 x 1 mm.
std::string grouped_part(const std::string& name, const std::string& id, const std::string& more = "") {
  return part(name, "(tstamp " + id + ")" + more + "(fp_rect (start 0 0) (end 1 1) (layer \"F.CrtYd\"))");
}

std::vector<std::string> members(const Board& b, const std::string& group) {
  for (const PartGroup& g : b.groups)
    if (g.name == group) return g.parts;
  return {"no such group"};
}

TEST(ReadBoard, Groups) {
  using Names = std::vector<std::string>;
  const Board b =
      read_board(board(std::string(kOutline) + grouped_part("R1", "1") + grouped_part("R2", "2") + part("R3", "") +
                       "(group \"\" (id 10) (members 2 1 99))(group \"\" (id 11) (members 10))"
                       "(group \"locked\" (id 12) (members 2))(group \"a\" locked (id 13) (members 14))"
                       "(group \"b\" (id 14) (members 13 1))(group \"texts\" (id 15) (members 99))(group \"none\")"),
                 "b");
  ASSERT_EQ(b.groups.size(), 5U);
  EXPECT_EQ(members(b, "group"), (Names{"R1", "R2"}));
  EXPECT_EQ(members(b, "group 2"), (Names{"R1", "R2"}));
  EXPECT_EQ(members(b, "locked"), (Names{"R2"}));
  EXPECT_EQ(members(b, "a"), (Names{"R1"}));  // around each other: all that is in either
  EXPECT_EQ(members(b, "b"), (Names{"R1"}));
  EXPECT_TRUE(b.find("R1")->locked);   // in a locked group
  EXPECT_FALSE(b.find("R2")->locked);  // in a group of that name
  expect_refused(board(std::string(kOutline) + "(group \"a\" (id (b)))"), "a word is meant here", "b.kicad_pcb:3:");
}

TEST(ReadBoard, ManyMembersOfGroupsInGroupsAreRefused) {
  std::string chain;
  for (int k = 0; k < 3000; ++k)
    chain += "(group \"g\" (id g" + std::to_string(k) + ") (members g" + std::to_string(k + 1) + "))\n";
  expect_refused(board(std::string(kOutline) + chain), "groups with so many members", "");
}

TEST(ReadBoard, LockedInAllNotations) {
  for (const auto& [text, locked] : std::map<std::string, bool>{
           {"locked ", true}, {"(locked yes) ", true}, {"(locked) ", true}, {"(locked no) ", false}, {"", false}}) {
    const std::string footprint = part("R1", "(fp_rect (start 0 0) (end 1 1) (layer \"F.CrtYd\"))");
    const std::string given = "(footprint \"F\" " + text + footprint.substr(std::string("(footprint \"F\" ").size());
    EXPECT_EQ(read_board(board(std::string(kOutline) + given), "b").find("R1")->locked, locked) << text;
  }
}

TEST(ReadBoard, CurvesAreSegmentsThatHardlyDepart) {
  // Four parts of a circle of radius 10 as curves; a curve lies outside of it by 2.7e-4 of the radius at most.
  const auto quarter = [](const char* pts) {
    return "(gr_curve (pts " + std::string(pts) + ") (layer \"Edge.Cuts\"))";
  };
  const std::string outline = quarter("(xy 10 0) (xy 10 5.522847) (xy 5.522847 10) (xy 0 10)") +
                              quarter("(xy 0 10) (xy -5.522847 10) (xy -10 5.522847) (xy -10 0)") +
                              quarter("(xy -10 0) (xy -10 -5.522847) (xy -5.522847 -10) (xy 0 -10)") +
                              quarter("(xy 0 -10) (xy 5.522847 -10) (xy 10 -5.522847) (xy 10 0)");
  const Board b = read_board(board(outline), "b");
  EXPECT_NEAR(area(b.outline), 100 * std::acos(-1.0), 0.1);
  ASSERT_EQ(b.notes.size(), 1U);
  EXPECT_NE(b.notes[0].find("4 Bézier curves"), std::string::npos) << b.notes[0];
}

TEST(ReadBoard, RefusesAPartTwice) {
  const std::string pad = "(pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\"))";
  expect_refused(board(kOutline + part("R1", pad) + part("R1", pad)), "a second footprint 'R1'");
  const Board two = read_board(board(kOutline + part("REF**", pad) + part("REF**", pad)), "b");
  ASSERT_EQ(two.parts.size(), 2U);
  EXPECT_EQ(two.parts[1].name, "REF** 2");
}

TEST(ReadBoard, ArcsInBothNotations) {
  const std::string sides =
      "(gr_line (start 0 0) (end 8 0) (layer \"Edge.Cuts\")) (gr_line (start 10 2) (end 10 10) (layer \"Edge.Cuts\"))"
      "(gr_line (start 10 10) (end 0 10) (layer \"Edge.Cuts\")) (gr_line (start 0 10) (end 0 0) (layer \"Edge.Cuts\"))";
  const double expected = 100 - 4 + std::acos(-1.0);
  const std::string by_angle = "(gr_arc (start 8 2) (end 8 0) (angle 90) (layer \"Edge.Cuts\"))";
  const std::string by_points = "(gr_arc (start 8 0) (mid 9.414214 0.585786) (end 10 2) (layer \"Edge.Cuts\"))";
  EXPECT_NEAR(area(read_board(board(sides + by_angle, "20171130"), "b").outline), expected, 1e-9);
  EXPECT_NEAR(area(read_board(board(sides + by_points), "b").outline), expected, 1e-5);
}

TEST(ReadBoard, WhatIsDrawnTwiceIsOne) {
  const std::string hole = "(gr_circle (center 5 5) (end 6 5) (layer \"Edge.Cuts\"))";
  const std::string yard = "(fp_circle (center 0 0) (end 1 0) (layer \"F.CrtYd\"))";
  const double disc = std::acos(-1.0);
  for (const char* at : {"3 3", "3 3 30"}) {
    const Board b = read_board(board(kOutline + hole + hole + part("R1", yard + yard, at)), "b");
    EXPECT_NEAR(area(b.outline), 100 - disc, 1e-5);
    EXPECT_NEAR(area(b.parts[0].body), disc, 1e-5);
    EXPECT_FALSE(b.parts[0].stands_in);
  }
  // Half a disc by an arc about its centre, in both directions.
  const std::string half =
      "(fp_line (start -1 0) (end 1 0) (layer \"F.CrtYd\")) (fp_arc (start 0 0) (end 1 0) (angle 180) (layer "
      "\"F.CrtYd\"))"
      "(fp_arc (start 0 0) (end 1 0) (angle 180) (layer \"F.CrtYd\"))"
      "(fp_arc (start 0 0) (end -1 0) (angle -180) (layer \"F.CrtYd\"))";
  EXPECT_NEAR(area(read_board(board(kOutline + part("R1", half), "20171130"), "b").parts[0].body), disc / 2, 1e-5);
}

TEST(ReadBoard, JoinsSmallGaps) {
  const std::string gap =
      "(gr_line (start 0 0) (end 10 0) (layer \"Edge.Cuts\")) (gr_line (start 10.005 0) (end 0 10) (layer "
      "\"Edge.Cuts\"))"
      "(gr_line (start 0 10) (end 0 0) (layer \"Edge.Cuts\"))";
  const Board joined = read_board(board(gap), "b");
  EXPECT_EQ(area(joined.outline), 50);
  ASSERT_FALSE(joined.notes.empty());
  EXPECT_NE(joined.notes[0].find("1 ends up to 0.01 mm apart"), std::string::npos) << joined.notes[0];
}

TEST(ReadBoard, PadsTurnWithTheBoard) {
  const auto pad = [](const std::string& kind, const std::string& more) {
    return read_board(
               board(kOutline +
                     part("R1", "(pad \"1\" smd " + kind + " (at 1 0 90) (size 2 1) (layers \"F.Cu\")" + more + ")",
                          "5 5 90")),
               "b")
        .parts[0]
        .pads[0]
        .copper;
  };
  EXPECT_EQ(area(pad("rect", "")), 2);
  EXPECT_NEAR(area(pad("oval", "")), 1 + std::acos(-1.0) / 4, 1e-9);
  EXPECT_NEAR(area(pad("roundrect", "(roundrect_rratio 0.25)")), 2 - (4 - std::acos(-1.0)) / 16, 1e-9);
  EXPECT_NEAR(area(pad("roundrect", "(roundrect_rratio 0) (chamfer_ratio 0.5) (chamfer top_left)")), 1.875, 1e-9);
  // A quarter turn counter-clockwise, where y runs downwards, takes (1, 0) to (0, -1).
  const plane::ShapePtr ring = pad("rect", "");
  for (const plane::ContourEdge& e : ring->contours[0]) {
    EXPECT_EQ(std::abs(e.start.x - 5000000), 500000);
    EXPECT_EQ(std::abs(e.start.y - 4000000), 1000000);
  }
}

TEST(ReadBoard, BoxStandsInForACourtyard) {
  const std::string pad = "(pad \"1\" smd rect (at 0 0) (size 2 1) (layers \"F.Cu\"))";
  const std::string body = "(fp_line (start -2 -1) (end 2 1) (layer \"F.Fab\"))";
  const Board read = read_board(board(kOutline + part("R1", pad + body)), "b");
  EXPECT_TRUE(read.parts[0].stands_in);
  EXPECT_NEAR(area(read.parts[0].body), 8, 0.2);
  EXPECT_GE(area(read.parts[0].body), 8);
}

TEST(ReadBoard, BoxThatStandsInCoversPads) {
  const std::string small = "(pad \"2\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\"))";
  for (const auto& [pad, expected] : std::map<std::string, double>{
           {"smd trapezoid (at 0 0) (size 2 2) (rect_delta 1 0) (layers \"F.Cu\")", 6},
           {"smd trapezoid (at 0 0 90) (size 2 2) (rect_delta 1 0) (layers \"F.Cu\")", 6},
           {"thru_hole rect (at 0 0) (size 2 1) (drill 0.5 (offset 1 0)) (layers \"*.Cu\")", 2.5},
           {"thru_hole rect (at 0 0 180) (size 2 1) (drill 0.5 (offset 1 0)) (layers \"*.Cu\")", 2.5},
           {"smd custom (at 0 0 90) (size 1 1) (layers \"F.Cu\") (options (anchor rect)) (primitives (gr_line (start 0 "
            "0) (end 3 0) (width 1)))",
            4}}) {
    const Board read = read_board(board(kOutline + part("R1", small + "(pad \"1\" " + pad + ")")), "b");
    const Part& only = read.parts[0];
    EXPECT_TRUE(only.stands_in);
    EXPECT_NEAR(area(only.body), expected, 0.1) << pad;
    for (const Pad& p : only.pads) EXPECT_NEAR(area(united({only.body, p.copper}, "")), area(only.body), 1e-9) << pad;
  }
}

TEST(ReadBoard, DotsOfTheDrawnBodyArePassedOver) {
  const std::string dots =
      "(fp_circle (center 4 4) (end 4 4) (layer \"F.SilkS\"))"
      "(fp_circle (center 4 4) (end 4 4) (layer \"F.Fab\"))";
  const std::string pad = "(pad \"1\" smd rect (at 0 0) (size 2 1) (layers \"F.Cu\"))";
  const std::string yard = "(fp_rect (start -1 -1) (end 1 1) (layer \"F.CrtYd\"))";
  EXPECT_EQ(area(read_board(board(kOutline + part("R1", pad + dots + yard)), "b").parts[0].body), 4);
  EXPECT_NEAR(area(read_board(board(kOutline + part("R1", pad + dots)), "b").parts[0].body), 2, 0.1);
  expect_refused(board(kOutline + part("R1", "(fp_circle (center 4 4) (end 4 4) (layer \"F.CrtYd\"))")), "radius 0");
}

TEST(ReadBoard, ViasAreOnAllCopperLayersBetween) {
  using Names = std::vector<std::string>;
  const auto layers = [](const std::string& version, const std::string& stack, const std::string& via) {
    return read_board("(kicad_pcb (version " + version + ") (layers " + stack + " (44 Edge.Cuts user))" + kOutline +
                          "(via (at 2 2) (size 0.6) (drill 0.3) (layers " + via + ") (net 0)))",
                      "b")
        .vias[0]
        .layers;
  };
  const std::string four = "(0 \"F.Cu\" signal) (4 \"In1.Cu\" signal) (6 \"In2.Cu\" power) (2 \"B.Cu\" signal)";
  EXPECT_EQ(layers("20241229", four, "\"F.Cu\" \"B.Cu\""), (Names{"F.Cu", "In1.Cu", "In2.Cu", "B.Cu"}));
  EXPECT_EQ(layers("20241229", four, "\"B.Cu\" \"In2.Cu\""), (Names{"In2.Cu", "B.Cu"}));
  EXPECT_EQ(layers("20171130", "(0 Top signal) (1 GND power) (31 Bottom signal)", "Top Bottom"),
            (Names{"F.Cu", "GND", "B.Cu"}));
}

TEST(MoveBoard, ChangesNothingElse) {
  const std::string text = board(kOutline + part("R1", "(pad \"1\" smd rect (at 1 0) (size 2 1) (layers \"F.Cu\"))"));
  EXPECT_EQ(moved_board(text, "b", {}), text);
  const std::string moved = moved_board(text, "b", {{"R1", {{-1500000, 2000001}, 90}}});
  std::string expected = text;
  const auto replace = [&](const std::string& from, const std::string& to) {
    expected.replace(expected.find(from), from.size(), to);
  };
  replace("(at 5 5)", "(at -1.5 2.000001 90)");
  replace("(at 0 0)", "(at 0 0 90)");
  replace("(at 1 0)", "(at 1 0 90)");
  EXPECT_EQ(moved, expected);
  EXPECT_THROW(moved_board(text, "b", {{"R2", {}}}), Error);
}

TEST(BoardScene, NamesAndSides) {
  const std::string yard = "(fp_rect (start -1 -1) (end 1 1) (layer \"F.CrtYd\"))";
  const auto read = std::make_shared<const Board>(
      read_board(board(kOutline + part("R1", yard, "3 3") + part("R2", yard, "7 7")), "b"));
  BoardQuestion question;
  question.move = {"R1"};
  const Scene scene = board_scene(read, question);
  EXPECT_EQ(scene.moving, std::vector<std::string>{"R1"});
  ASSERT_TRUE(scene.find("others"));
  EXPECT_EQ(scene.shape("others")->children.size(), 1U);
  EXPECT_EQ(scene.groups.at("parts"), (std::vector<std::string>{"R1", "R2"}));
  question.move = {"R9"};
  EXPECT_THROW(board_scene(read, question), Error);
}

}  // namespace io_board
}  // namespace findspace::io
