// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SVG and DXF drawings: bad input first, then units, transforms, choice, nesting.
#include <gtest/gtest.h>

#include "findspace/error.h"
#include "io/read/read_file.h"
#include "plane/build/build.h"
#include "plane/query/summary.h"

namespace findspace::io {
namespace io_read_drawings {

using exact::Real;
using plane::GridPoint;
using plane::Shape;
using plane::ShapePtr;

/// A context of whole millimetres.
struct Context : ReadContext {
  Context() {
    grid = Grid(1);
    unit = Unit::kMillimetre;
  }
};

ShapePtr svg(const std::string& inside, FileChoice choice = {},
             const std::string& attributes = "width='100mm' viewBox='0 0 100 100'") {
  Context context;
  return read_svg("<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + inside + "</svg>", "f.svg", choice,
                  context);
}

/// Open outlines taken for lines.
ShapePtr lines(const std::string& inside) {
  Context context;
  context.drawing.open_lines = true;
  return read_svg("<svg width='100mm' viewBox='0 0 100 100'>" + inside + "</svg>", "f.svg", {}, context);
}

template <class Read>
void expect_refused(Read read, const std::string& words) {
  try {
    read();
    ADD_FAILURE() << "read, expected: " << words;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("f."), std::string::npos) << e.what();
  }
}

TEST(ReadSvg, Refuses) {
  Context context;
  for (const char* text : {"", "<svg", "<svg><path d='M0 0'></svg>", "\x89PNG\r\n\x1a\n"}) {
    expect_refused([&] { read_svg(text, "f.svg", {}, context); }, "not proper XML");
  }
  expect_refused([&] { read_svg("<html/>", "f.svg", {}, context); }, "not <svg>");
  expect_refused([] { svg(""); }, "no shape");
  expect_refused([] { svg("\n<path id='p' d='M0 0 X'/>"); }, "<path id='p'> (f.svg:2:2): path, character 6");
  expect_refused([] { svg("<circle r='-1'/>"); }, "'r' must not be less than 0");
  expect_refused([] { svg("<circle r='1em'/>"); }, "the unit 'em'");
  expect_refused([] { svg("<rect width='5' height='-5'/>"); }, "'height' must not be less than 0");
  expect_refused([] { svg("<rect width='50%' height='5'/>", {}, ""); }, "the unit '%'");
  expect_refused([] { svg("<path d='M0 0 H9 V9'/><path d='M0 9 V1'/>"); },
                 "2 outlines are open, the first from (0, 0) to (9, -9); the narrowest gap is 1 mm");
  expect_refused([] { svg("<polygon points='0 0 1'/>"); }, "odd number");
  expect_refused([] { svg("<polygon points='0 0 4 0 4 4' transform='turn(3)'/>"); }, "no such transform");
  expect_refused([] { svg("<use href='#a'/>"); }, "which is not in the drawing");
  expect_refused([] { svg("<g id='a'><use href='#a'/></g>"); }, "nested too deeply");
  expect_refused([] { svg("<circle r='1' transform='scale(1'/>"); }, "incomplete");
  FileChoice choice;
  choice.id = "outlin";
  expect_refused([&] { svg("<circle id='outline' r='3'/>", choice); }, "did you mean 'outline'?");
}

TEST(ReadSvg, ElementsOfNoSizeDrawNothing) {
  const std::string nothing =
      "<path d=' '/><path d='M1 1'/><circle r='0'/><circle/><ellipse rx='0' ry='3'/><rect width='0' height='5'/>"
      "<rect width='5'/><polygon points=''/>";
  expect_refused([&] { svg(nothing); }, "no shape");
  Context context;
  const std::string drawing = "<svg width='100mm' viewBox='0 0 100 100'>" + nothing + "<circle r='3'/></svg>";
  EXPECT_EQ(read_svg(drawing, "f.svg", {}, context)->kind, Shape::Kind::kDisc);
  EXPECT_EQ(context.notes,
            (std::vector<std::string>{"f.svg: 2 <circle> of no size left out", "f.svg: 1 <ellipse> of no size left out",
                                      "f.svg: 2 <path> of no size left out", "f.svg: 1 <polygon> of no size left out",
                                      "f.svg: 2 <rect> of no size left out"}));
  EXPECT_EQ(svg("<ellipse ry='3'/>")->kind, Shape::Kind::kDisc);  // rx is as ry where it is not stated
}

TEST(ReadSvg, StandsAsThePictureShows) {
  ShapePtr p = svg("<path d='M10 0 A10 10 0 0 1 0 10 V0 Z'/>");  // sweep 1 is clockwise in the picture
  ASSERT_EQ(p->kind, Shape::Kind::kRings);
  bool found = false;
  for (const plane::ContourEdge& e : p->contours[0]) {
    EXPECT_LE(e.start.y, 0);
    if (!e.arc) continue;
    found = true;
    EXPECT_TRUE(e.ccw);  // the ring has been rotated, the arc still bulges away from the centre
    EXPECT_EQ(e.arc->cx.sign(), 0);
    EXPECT_EQ(e.arc->cy.sign(), 0);
  }
  EXPECT_TRUE(found);
}

TEST(ReadSvg, Elements) {
  ShapePtr circle = svg("<circle cx='3' cy='4' r='2.5'/>");
  EXPECT_EQ(circle->kind, Shape::Kind::kDisc);
  EXPECT_EQ(circle->points[0], (GridPoint{3, -4}));
  EXPECT_EQ(compare(circle->amount, Real::ratio(5, 2)), 0);
  EXPECT_EQ(svg("<rect x='1' y='1' width='8' height='4'/>")->contours[0].size(), 4u);
  ShapePtr rounded = svg("<rect width='20' height='10' rx='3'/>");
  EXPECT_EQ(rounded->contours[0].size(), 8u);
  EXPECT_EQ(svg("<rect width='20' height='10' rx='5'/>")->contours[0].size(), 6u);  // a stadium
  EXPECT_EQ(svg("<rect width='10' height='10' rx='9'/>")->contours[0].size(), 4u);  // a circle
  EXPECT_EQ(lines("<line x1='0' y1='0' x2='5' y2='5'/>")->kind, Shape::Kind::kPolyline);
  EXPECT_EQ(lines("<polyline points='0,0 5,0 5,5'/>")->kind, Shape::Kind::kPolyline);
  EXPECT_EQ(svg("<polyline points='0,0 5,0 5,5'/><line x2='5' y2='5'/>")->kind, Shape::Kind::kRings);  // joined
  EXPECT_EQ(svg("<circle r='25.4mm'/>")->amount.integer(), exact::int128(96));
  EXPECT_EQ(svg("<polygon points='0,0 5,0 5,5'/>")->kind, Shape::Kind::kRings);
}

TEST(ReadSvg, Transforms) {
  EXPECT_EQ(svg("<g transform='translate(10)'><g transform='scale(2)'><circle r='3'/></g></g>")->points[0],
            (GridPoint{10, 0}));
  ShapePtr rotated = svg("<circle cx='5' r='3' transform='rotate(90)'/>");
  EXPECT_EQ(rotated->points[0], (GridPoint{0, -5}));
  EXPECT_EQ(rotated->amount.integer(), exact::int128(3));
  EXPECT_EQ(svg("<circle cx='10' r='3' transform='rotate(30)'/>")->points[0], (GridPoint{9, -5}));
  EXPECT_EQ(svg("<circle cx='10' r='3' transform='rotate(30)'/>")->amount.integer(), exact::int128(3));
  EXPECT_EQ(svg("<circle cx='1' cy='2' r='5' transform='matrix(0.6 0.8 -0.8 0.6 4 4)'/>")->amount.integer(),
            exact::int128(5));
  ShapePtr mirrored = svg("<path d='M10 0 A10 10 0 0 1 0 10 V0 Z' transform='scale(-1, 1)'/>");
  EXPECT_EQ(mirrored->contours[0].size(), 3u);
  EXPECT_EQ(svg("<polygon points='0 0 4 0 4 4' transform='rotate(180 2 2) skewX(45)'/>")->contours[0].size(), 3u);
}

TEST(ReadSvg, Units) {
  auto radius = [](const char* attributes, FileChoice choice = {}) {
    return svg("<circle r='90'/>", choice, attributes)->amount;
  };
  EXPECT_EQ(radius("width='10cm' viewBox='0 0 100 100'").integer(), exact::int128(90));
  EXPECT_EQ(compare(radius("width='1in' viewBox='0 0 90 90'"), Real::ratio(254, 10)), 0);
  EXPECT_EQ(compare(radius("width='100mm' height='50mm'"), Real::ratio(90 * 254, 960)), 0);
  EXPECT_EQ(radius("width='300' viewBox='0 0 100 100'").integer(), exact::int128(90));  // no unit: the scene's
  FileChoice inches;
  inches.unit = Unit::kInch;
  EXPECT_EQ(radius("", inches).integer(), exact::int128(2286));
  expect_refused([] { svg("<circle r='1'/>", {}, "width='1mm' viewBox='0 0 0 0'"); }, "viewBox");
}

TEST(ReadSvg, Choice) {
  const char* drawing =
      "<defs><circle id='spare' r='9'/></defs><g inkscape:label='cuts' id='l1'><circle id='a' r='1'/><circle id='b' "
      "r='2'/></g>"
      "<circle id='c' r='3'/><circle style='display: none' r='4'/><text>hello</text>";
  Context context;
  ShapePtr all = read_svg(std::string("<svg xmlns:inkscape='x'>") + drawing + "</svg>", "f.svg", {}, context);
  EXPECT_TRUE(all->collection);
  ASSERT_EQ(all->children.size(), 3u);
  EXPECT_EQ(all->children[1]->name, "b");
  EXPECT_EQ(context.notes.back(), "f.svg: 1 <text> left out; an editor turns text into paths");
  FileChoice choice;
  choice.layer = "cuts";
  EXPECT_EQ(svg(drawing, choice)->children.size(), 2u);
  choice.index = 1;
  EXPECT_EQ(svg(drawing, choice)->amount.integer(), exact::int128(2));
  FileChoice spare;
  spare.id = "spare";
  EXPECT_EQ(svg(drawing, spare)->amount.integer(), exact::int128(9));
}

/// Groups "code value" split at blanks and bars: one group a bar.
std::string dxf_text(const std::string& entities, const std::string& units = "", const std::string& blocks = "") {
  std::string groups =
      "0 SECTION|2 HEADER|" + (units.empty() ? std::string() : "9 $INSUNITS|70 " + units + "|") + "0 ENDSEC|";
  if (!blocks.empty()) groups += "0 SECTION|2 BLOCKS|" + blocks + "0 ENDSEC|";
  groups += "0 SECTION|2 ENTITIES|" + entities + "0 ENDSEC|0 EOF|";
  std::string text;
  bool code = true;
  for (char c : groups) {
    if (c == '|') {
      text += "\r\n";
      code = true;
    } else if (c == ' ' && code) {
      text += "\r\n";
      code = false;
    } else {
      text += c;
    }
  }
  return text;
}

ShapePtr dxf(const std::string& entities, FileChoice choice = {}, const std::string& units = "4",
             const std::string& blocks = "") {
  Context context;
  return read_dxf(dxf_text(entities, units, blocks), "f.dxf", choice, context);
}

const std::string kSquare = "0 LWPOLYLINE|8 cut|90 4|70 1|10 0|20 0|10 20|20 0|10 20|20 20|10 0|20 20|";

/// What is drawn by several elements, as one part: an outline within another is its hole.
TEST(OnePart, NestsOverAllElements) {
  Context context;
  context.drawing.parts = PartRule::kOne;
  const auto rings = [](const ShapePtr& shape) {
    EXPECT_EQ(shape->kind, Shape::Kind::kRings);
    return shape->contours.size();
  };
  const std::string svg = "<svg width='100mm' viewBox='0 0 100 100'><rect width='50' height='20'/>";
  const std::string with_hole = svg + "<g><circle cx='10' cy='10' r='5'/></g></svg>";
  EXPECT_EQ(rings(read_svg(with_hole, "f.svg", {}, context)), 2U);
  FileChoice second;
  second.index = 1;  // of the elements, as in scenes
  EXPECT_EQ(read_svg(with_hole, "f.svg", second, context)->kind, Shape::Kind::kDisc);
  EXPECT_EQ(read_svg(svg + "<rect x='60' width='9' height='9'/></svg>", "f.svg", {}, context)->children.size(), 2U);
  const std::string outer = "[[[0,0],[50,0],[50,20],[0,20],[0,0]]]", inner = "[[[5,5],[9,5],[9,9],[5,5]]]";
  const auto feature = [](const std::string& coordinates) {
    return R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": )" + coordinates + "}}";
  };
  const std::string features =
      R"({"type": "FeatureCollection", "features": [)" + feature(outer) + "," + feature(inner) + "]}";
  EXPECT_EQ(rings(read_geojson(features, "f.geojson", {}, context)), 2U);
  EXPECT_EQ(rings(read_wkt("POLYGON((0 0,50 0,50 20,0 20,0 0)) LINESTRING(5 5,9 5,9 9,5 5)", "f.wkt", {}, context)),
            2U);
  const std::string crossed = svg + "<circle cx='50' cy='10' r='5'/></svg>";
  expect_refused([&] { read_svg(crossed, "f.svg", {}, context); }, "touches or crosses");
}

TEST(ReadDxf, Refuses) {
  Context context;
  for (const char* text : {"", "0\n", "0\nSECTION\n2\nENTITIES\n0\nLINE\n"}) {
    expect_refused([&] { read_dxf(text, "f.dxf", {}, context); }, "cut off");
  }
  expect_refused([&] { read_dxf("hello\nworld\n", "f.dxf", {}, context); }, "not ASCII DXF");
  expect_refused([&] { read_dxf(std::string_view("AutoCAD Binary DXF\r\n\x1a\0xxx", 25), "f.dxf", {}, context); },
                 "cut off");
  expect_refused([] { dxf(""); }, "no shape");
  expect_refused([] { dxf("0 LINE|10 0|20 0|11 5|"); }, "LINE (f.dxf:16): group 21 is missing");
  expect_refused([] { dxf("0 LINE|10 x|20 0|11 5|21 0|"); }, "'x' is not a number");
  expect_refused([] { dxf("0 CIRCLE|10 0|20 0|40 -1|"); }, "radius");
  expect_refused([] { dxf("0 SPLINE|8 0|"); }, "a curve of degree 0");
  expect_refused([] { dxf("0 SPLINE|71 3|11 0|21 0|11 5|21 5|"); }, "leaves open how it runs between them");
  expect_refused([] { dxf("0 REGION|8 0|"); }, "REGION is not read");
  expect_refused([] { dxf("0 CIRCLE|10 0|20 0|40 5|220 1|230 0|"); }, "plane is slanted");
  expect_refused([] { dxf("0 ELLIPSE|10 0|20 0|11 9|21 0|40 0.5|210 0|220 0.6|230 0.8|"); }, "plane is slanted");
  expect_refused([] { dxf("0 INSERT|2 none|10 0|20 0|"); }, "unknown block");
  expect_refused([] { dxf("0 POLYLINE|70 1|0 VERTEX|10 0|20 0|"); }, "without SEQEND");
  expect_refused([] { dxf(kSquare, {}, "7"); }, "$INSUNITS 7");
  expect_refused([] { dxf("0 LINE|10 0|20 0|11 5|21 0|0 LINE|10 0|20 0|11 0|21 5|0 LINE|10 0|20 0|11 5|21 5|"); },
                 "3 lines end at (0, 0)");
  expect_refused([] { dxf(kSquare + "0 CIRCLE|10 20|20 10|40 5|"); }, "touches or crosses");
  FileChoice choice;
  choice.layer = "cuts";
  expect_refused([&] { dxf(kSquare, choice); }, "did you mean 'cut'?");
  expect_refused(
      [] { dxf("0 INSERT|2 b|10 0|20 0|", {}, "4", "0 BLOCK|2 b|10 0|20 0|0 INSERT|2 b|10 0|20 0|0 ENDBLK|"); },
      "in themselves");
}

TEST(ReadDxf, OutlinesNestAndUnits) {
  ShapePtr plate = dxf(kSquare + "0 CIRCLE|8 cut|10 10|20 10|40 5|0 TEXT|1 hello|");
  ASSERT_EQ(plate->kind, Shape::Kind::kRings);
  EXPECT_EQ(plate->contours.size(), 2u);
  EXPECT_EQ(dxf("0 CIRCLE|10 1|20 1|40 2|", {}, "5")->amount.integer(), exact::int128(20));
  EXPECT_EQ(compare(dxf("0 CIRCLE|10 1|20 1|40 2|", {}, "1")->amount, Real::ratio(508, 10)), 0);
  Context context;
  read_dxf(dxf_text(kSquare), "f.dxf", {}, context);
  EXPECT_EQ(context.notes.at(0), "f.dxf states no unit: read as mm");
}

TEST(ReadDxf, BulgesAndArcs) {
  ShapePtr stadium = dxf("0 LWPOLYLINE|70 1|10 0|20 0|10 10|20 0|42 1|10 10|20 10|10 0|20 10|42 1|");
  ASSERT_EQ(stadium->contours[0].size(), 4u);
  EXPECT_EQ(stadium->contours[0][1].arc->cx.integer(), exact::int128(10));
  EXPECT_EQ(stadium->contours[0][1].arc->cy.integer(), exact::int128(5));
  ShapePtr pieces =
      dxf("0 LINE|10 0|20 0|11 10|21 0|0 ARC|10 10|20 5|40 5|50 270|51 90|0 LINE|10 0|20 10|11 10|21 10|0 LINE|10 0|20 "
          "10|11 0|21 0|");
  ASSERT_EQ(pieces->kind, Shape::Kind::kRings);
  EXPECT_EQ(pieces->contours[0].size(), 4u);
  ShapePtr old = dxf("0 POLYLINE|70 1|0 VERTEX|10 0|20 0|0 VERTEX|10 9|20 0|42 0.5|0 VERTEX|10 9|20 9|0 SEQEND|");
  EXPECT_EQ(old->contours[0].size(), 3u);
  EXPECT_EQ(dxf("0 ARC|10 0|20 0|40 7|50 33|51 393|")->kind, Shape::Kind::kDisc);
  EXPECT_EQ(dxf("0 POINT|10 3|20 4|")->points[0], (GridPoint{3, 4}));
}

TEST(ReadDxf, OpenOutlinesAreRefusedJoinedOrNoted) {
  const std::string gaps =
      "0 LINE|10 0|20 0|11 50|21 0|0 LINE|10 52|20 1|11 50|21 50|0 ARC|10 25|20 50|40 25|50 0|51 180|0 LINE|10 0|20 "
      "49|11 0|21 1|";
  expect_refused([&] { dxf(gaps); },
                 "3 outlines are open, the first from (0, 0) to (50, 0); the narrowest gap is 1 mm");
  Context joining;
  joining.drawing.join = 3;
  ShapePtr closed = read_dxf(dxf_text(gaps, "4"), "f.dxf", {}, joining);
  ASSERT_EQ(closed->kind, Shape::Kind::kRings);
  EXPECT_EQ(closed->contours[0].size(), 4u);
  EXPECT_EQ(joining.notes.at(0), "f.dxf: 3 gaps closed, the widest 2.24 mm at (50, 0)");
  Context context;
  context.drawing.open_lines = true;
  ShapePtr open =
      read_dxf(dxf_text("0 LINE|10 0|20 0|11 5|21 0|0 LINE|10 5|20 0|11 5|21 5|", "4"), "f.dxf", {}, context);
  EXPECT_EQ(open->kind, Shape::Kind::kPolyline);
  EXPECT_EQ(context.notes.at(0), "f.dxf: 1 open outline is read as a polyline, without an inside");
}

TEST(ReadDxf, LinesThatHangOnAnOutlineAreLines) {
  const auto line = [](const std::string& from, const std::string& to) {
    const auto at = [](const std::string& p, const std::string& digit) {
      return "1" + digit + " " + p.substr(0, p.find(',')) + "|2" + digit + " " + p.substr(p.find(',') + 1) + "|";
    };
    return "0 LINE|" + at(from, "0") + at(to, "1");
  };
  const auto parts = [](const std::string& entities) {
    Context context;
    context.drawing.open_lines = true;
    const ShapePtr shape = read_dxf(dxf_text(entities, "4"), "f.dxf", {}, context);
    const plane::Region region = plane::build(*shape, context.grid.step_size()).region;
    const plane::Summary found = plane::summarize(region, Real(1));
    return std::array{found.area.value(), found.dangling_length};
  };
  const std::string star = line("50,0", "60,0") + line("50,0", "50,10") + line("50,-10", "50,0");
  const std::string triangle = line("0,0", "20,0") + line("20,0", "0,20") + line("0,20", "0,0");
  EXPECT_EQ(parts(star), (std::array{0.0, 30.0}));
  EXPECT_EQ(parts(line("-9,0", "0,0") + triangle + star + line("-9,0", "-9,5")), (std::array{200.0, 44.0}));
  EXPECT_EQ(parts(line("-9,0", "0,0") + triangle + line("0,0", "0,-5")),
            (std::array{200.0, 14.0}));  // four at a corner
  expect_refused([&] { parts(triangle + line("0,0", "5,5") + line("5,5", "0,20")); }, "3 lines end at (0, 0)");
}

TEST(ReadDxf, WhatDrawsNothingIsLeftOut) {
  Context context;
  context.drawing.join = 2;
  ShapePtr square = read_dxf(
      dxf_text(kSquare + "0 LINE|10 3|20 3|11 3|21 3|0 LWPOLYLINE|70 0|10 4|20 4|" + "0 LINE|10 90|20 3|11 91|21 4|",
               "4"),
      "f.dxf", {}, context);
  ASSERT_EQ(square->kind, Shape::Kind::kRings);
  EXPECT_EQ(square->contours.size(), 1u);
  EXPECT_EQ(context.repeated_points, 2);
  EXPECT_EQ(context.notes.at(0), "f.dxf: 1 open line is no longer than the gaps that are closed, left out");
  expect_refused([] { dxf(kSquare + "0 LINE|10 90|20 3|11 91|21 4|"); }, "an outline is open");
}

TEST(ReadDxf, ALineThereAndBackIsALine) {
  const std::string back = "0 LWPOLYLINE|70 1|10 0|20 0|10 9|20 3|10 6|20 2|";
  expect_refused([&] { dxf(back); }, "no area");
  Context context;
  context.drawing.open_lines = true;
  EXPECT_EQ(read_dxf(dxf_text(back, "4"), "f.dxf", {}, context)->kind, Shape::Kind::kPolyline);
}

TEST(ReadDxf, ALineOutAndBackByTheSameCornersIsALine) {
  const std::string back = "0 LWPOLYLINE|70 1|10 0|20 0|10 90|20 30|10 60|20 2000|10 90|20 30|";
  expect_refused([&] { dxf(back); }, "run along each other");
  Context context;
  context.drawing.open_lines = true;
  EXPECT_EQ(read_dxf(dxf_text(back, "4"), "f.dxf", {}, context)->kind, Shape::Kind::kPolyline);
  // A square with a long spike: a square and a line.
  Context spiked;
  spiked.drawing.open_lines = true;
  const std::string spike =
      "0 LWPOLYLINE|70 1|10 0|20 0|10 9000|20 0|10 9000|20 4000|10 19700|20 4000|10 9000|20 4000|10 9000|20 9000|10 "
      "0|20 9000|";
  const plane::Summary both =
      plane::summarize(plane::build(*read_dxf(dxf_text(spike, "4"), "f.dxf", {}, spiked)).region, Real(1));
  EXPECT_EQ(both.area, 81e6);
  EXPECT_EQ(both.dangling_length, 10700);
  EXPECT_NE(spiked.notes.at(0).find("spikes are lines"), std::string::npos) << spiked.notes.at(0);
  // A bow tie of no area is none.
  Context again;
  again.drawing.open_lines = true;
  EXPECT_THROW(read_dxf(dxf_text("0 LWPOLYLINE|70 1|10 0|20 0|10 9000|20 9000|10 9000|20 0|10 0|20 9000|", "4"),
                        "f.dxf", {}, again),
               Error);
}

/// A square of 10,000 whose last corner is passed by 30 on one side and 40 on the other.
TEST(ReadDxf, CrossingsUpToTheJoinAreMended) {
  const std::string loop = "0 LWPOLYLINE|70 1|10 0|20 0|10 10040|20 0|10 10000|20 -30|10 10000|20 10000|10 0|20 10000|";
  expect_refused([&] { dxf(loop); }, "touches or crosses itself");
  expect_refused([&] { dxf(loop); }, "meet at (10000, 0); --join 50mm mends it");
  Context context;
  context.drawing.join = 50;
  ShapePtr shape = read_dxf(dxf_text(loop, "4"), "f.dxf", {}, context);
  ASSERT_EQ(shape->kind, Shape::Kind::kCells);
  EXPECT_EQ(context.notes.at(0),
            "f.dxf: outlines cross in 1 place, the longest 40 mm at (10010, -10): overlaps are joined, loops and "
            "spikes are left out");
  // A width of their own for crossings, 0 for none.
  for (const auto& [mend, hint] : {std::pair{0, "--mend 50mm mends it"}, {10, "--mend 50mm mends it"}}) {
    Context strict;
    strict.drawing.join = 50;
    strict.drawing.mend = mend;
    expect_refused([&] { read_dxf(dxf_text(loop, "4"), "f.dxf", {}, strict); }, hint);
  }
  Context wide;
  wide.drawing.mend = 50;
  EXPECT_EQ(read_dxf(dxf_text(loop, "4"), "f.dxf", {}, wide)->kind, Shape::Kind::kCells);
  // A spike of 700 and parts that overlap by 3; beside them what is sound stays as it is.
  Context more;
  const std::string spike =
      "0 LWPOLYLINE|70 1|10 0|20 0|10 9000|20 0|10 9000|20 4000|10 9700|20 4000|10 9000|20 4000|10 9000|20 9000|10 "
      "0|20 9000|";
  const std::string parts =
      "0 LWPOLYLINE|70 1|10 20000|20 0|10 29003|20 0|10 29003|20 9000|10 20000|20 9000|0 LWPOLYLINE|70 1|10 29000|20 "
      "10|10 39000|20 10|10 39000|20 8000|10 29000|20 8000|0 CIRCLE|10 50000|20 0|40 700|";
  shape = read_dxf(dxf_text(spike + parts, "4"), "f.dxf", {}, more);
  ASSERT_EQ(shape->children.size(), 4u);
  for (const std::size_t k : {0, 1, 2, 3}) EXPECT_EQ(shape->children[k]->kind, Shape::Kind::kRings) << k;
  EXPECT_NE(more.notes.at(0).find("outlines cross in 2 places, the longest 7.99e+03 mm"), std::string::npos)
      << more.notes.at(0);
}

TEST(ReadDxf, ArcsTooFlatForTheGridAreCurves) {
  // A radius of 125 km: 1.25e11 steps of a micrometre, and too many of a tenth of a nanometre.
  const std::string flat = "0 LWPOLYLINE|70 1|10 0|20 0|42 0.000002|10 1000|20 0|10 1000|20 50|10 0|20 50|";
  for (const auto& [step, curves] : {std::pair{Real::ratio(1, 1000), 0}, {Real::ratio(1, 10000000), 1}}) {
    Context context;
    context.grid = Grid(step);
    context.use({});
    ShapePtr shape = read_dxf(dxf_text(flat, "4"), "f.dxf", {}, context);
    ASSERT_EQ(shape->kind, Shape::Kind::kRings);
    EXPECT_EQ(context.curves.curves, curves);
  }
}

TEST(ReadDxf, FlatArcsOfManyPiecesEnd) {
  Context context;
  context.grid = Grid(Real::ratio(1, 1000000));
  context.use({});
  const std::string flat = "0 LWPOLYLINE|70 1|10 0|20 0|42 0.02|10 120000|20 0|10 120000|20 100000|10 0|20 100000|";
  ShapePtr shape = read_dxf(dxf_text(flat, "4"), "f.dxf", {}, context);
  ASSERT_EQ(shape->kind, Shape::Kind::kRings);
  EXPECT_LT(shape->contours[0].size(), 3000u);
}

TEST(ReadDxf, HeightsAreNoted) {
  auto notes = [](const std::string& entities) {
    Context context;
    context.drawing.open_lines = true;
    read_dxf(dxf_text(entities, "4", "0 BLOCK|2 b|10 0|20 0|0 LINE|10 0|20 0|11 5|21 0|0 ENDBLK|"), "f.dxf", {},
             context);
    return context.notes;
  };
  const std::string note = "f.dxf: 1 entity has a z other than 0, read as seen from above";
  EXPECT_EQ(notes("0 CIRCLE|10 0|20 0|30 0.0|40 5|"), std::vector<std::string>{});
  EXPECT_EQ(notes("0 CIRCLE|10 0|20 0|30 2|40 5|"), std::vector<std::string>{note});
  EXPECT_EQ(notes("0 LINE|10 0|20 0|30 0|11 5|21 0|31 -1|").at(1), note);
  EXPECT_EQ(notes("0 LWPOLYLINE|38 1|70 1|10 0|20 0|10 9|20 0|10 9|20 9|"), std::vector<std::string>{note});
  EXPECT_EQ(notes("0 POLYLINE|70 1|0 VERTEX|10 0|20 0|30 1|0 VERTEX|10 9|20 0|0 VERTEX|10 9|20 9|0 SEQEND|"),
            std::vector<std::string>{note});
  EXPECT_EQ(notes("0 INSERT|2 b|10 0|20 0|30 4|").at(1), note);
  EXPECT_EQ(notes("0 SPLINE|71 1|40 0|40 0|40 1|40 1|10 0|20 0|30 0|10 9000|20 0|30 3|").at(1), note);
}

std::vector<std::string> dxf_notes(const std::string& entities, const std::string& blocks = "",
                                   FileChoice choice = {}) {
  Context context;
  read_dxf(dxf_text(entities, "4", blocks), "f.dxf", choice, context);
  return context.notes;
}

TEST(ReadDxf, PaperSpaceAndWhatIsInvisibleAreNotRead) {
  const std::string block = "0 BLOCK|2 frame|10 0|20 0|0 CIRCLE|10 10|20 10|40 5|0 ENDBLK|";
  EXPECT_EQ(dxf(kSquare + "0 INSERT|67 1|2 frame|10 0|20 0|", {}, "4", block)->contours.size(), 1u);
  EXPECT_EQ(dxf_notes(kSquare + "0 INSERT|67 1|2 frame|10 0|20 0|", block), std::vector<std::string>{});
  const std::string unseen = kSquare + "0 CIRCLE|60 1|10 10|20 10|40 5|0 INSERT|60 1|2 frame|10 0|20 0|";
  EXPECT_EQ(dxf(unseen, {}, "4", block)->contours.size(), 1u);
  EXPECT_EQ(dxf_notes(unseen, block), std::vector<std::string>{"f.dxf: 2 invisible entities are left out"});
  EXPECT_EQ(dxf_notes(kSquare + "0 CIRCLE|60 0|10 10|20 10|40 5|"), std::vector<std::string>{});
}

TEST(ReadDxf, LayersThatAreOffOrFrozenAreReadWithANote) {
  const std::string layers =
      "0 ENDSEC|0 SECTION|2 TABLES|0 TABLE|2 LAYER|70 3|0 LAYER|2 cut|70 0|62 7|0 LAYER|2 off|70 0|62 -7|0 LAYER|2 "
      "frozen|70 1|62 7|0 ENDTAB|";
  const std::string entities = kSquare + "0 CIRCLE|8 off|10 5|20 5|40 2|0 CIRCLE|8 frozen|10 15|20 15|40 2|";
  EXPECT_EQ(dxf(entities + layers)->contours.size(), 3u);
  EXPECT_EQ(
      dxf_notes(entities + layers),
      std::vector<std::string>{"f.dxf: 2 entities come from layers that are off or frozen; \"layer\" chooses a layer"});
  FileChoice off;
  off.layer = "off";
  EXPECT_EQ(dxf_notes(entities + layers, "", off), std::vector<std::string>{});
  const std::string block = "0 BLOCK|2 b|10 0|20 0|0 CIRCLE|8 cut|10 5|20 5|40 2|0 ENDBLK|";
  const std::vector<std::string> one{
      "f.dxf: 1 entity comes from layers that are off or frozen; \"layer\" chooses a layer"};
  EXPECT_EQ(dxf_notes(kSquare + "0 INSERT|8 frozen|2 b|10 0|20 0|" + layers, block), one);
  EXPECT_EQ(dxf_notes(kSquare + "0 INSERT|8 off|2 b|10 0|20 0|" + layers, block), std::vector<std::string>{});
}

TEST(ReadDxf, NamesOfLayersAndBlocksHaveNoSmallLetters) {
  const std::string block = "0 BLOCK|2 Part|10 0|20 0|0 CIRCLE|8 CUT|10 5|20 5|40 2|0 ENDBLK|";
  FileChoice cut;
  cut.layer = "Cut";
  EXPECT_EQ(dxf(kSquare + "0 INSERT|2 PART|10 0|20 0|", cut, "4", block)->contours.size(), 2u);
}

TEST(ReadDxf, InsertsOfOtherDrawingsAreNoted) {
  const std::string block = "0 BLOCK|2 other|70 4|10 0|20 0|1 other.dwg|0 ENDBLK|";
  EXPECT_EQ(dxf_notes(kSquare + "0 INSERT|2 other|10 0|20 0|", block),
            std::vector<std::string>{"f.dxf: 1 insert of another drawing is left out"});
}

TEST(ReadDxf, PolylinesInSpaceHaveNoPlaneOfTheirOwn) {
  const auto first = [](const std::string& flags) {
    return dxf("0 POLYLINE|70 " + flags + "|230 -1|0 VERTEX|10 1|20 0|0 VERTEX|10 9|20 0|0 VERTEX|10 9|20 9|0 SEQEND|")
        ->contours[0][0]
        .start.x;
  };
  EXPECT_GT(first("9"), 0);
  EXPECT_LT(first("1"), 0);
}

TEST(ReadDxf, WidthsOfPolylinesAreNoted) {
  const std::vector<std::string> note{"f.dxf: 1 polyline has a width, left out: the line in the middle is read"};
  EXPECT_EQ(dxf_notes("0 LWPOLYLINE|70 1|43 2.5|10 0|20 0|42 1|10 20|20 0|42 1|"), note);  // a donut
  EXPECT_EQ(dxf_notes("0 LWPOLYLINE|70 1|10 0|20 0|40 0|41 1|10 9|20 0|10 9|20 9|"), note);
  const std::string vertices = "0 VERTEX|10 0|20 0|0 VERTEX|10 9|20 0|41 1|0 VERTEX|10 9|20 9|0 SEQEND|";
  EXPECT_EQ(dxf_notes("0 POLYLINE|70 1|" + vertices), note);
  EXPECT_EQ(dxf_notes("0 LWPOLYLINE|70 1|43 0.0|10 0|20 0|10 9|20 0|10 9|20 9|"), std::vector<std::string>{});
}

TEST(ReadDxf, FullTurnsWithFewDigitsAreCircles) {
  EXPECT_EQ(dxf("0 ARC|10 0|20 0|40 7|50 0|51 359.9999999999|")->kind, Shape::Kind::kDisc);
  EXPECT_EQ(dxf("0 ARC|10 0|20 0|40 7|50 0.0000001|51 0|")->kind, Shape::Kind::kDisc);
}

TEST(ReadDxf, WhatNeverEndsIsRefused) {
  const std::string ellipse = "0 ELLIPSE|10 0|20 0|11 9|21 0|40 0.5|";
  expect_refused([&] { dxf(ellipse + "41 1e18|42 0|"); }, "more than a thousand turns");
  expect_refused([&] { dxf(ellipse + "41 0|42 -1e30|"); }, "more than a thousand turns");
  for (const char* from : {"1e18", "-1e30"})
    expect_refused(
        [&] { dxf("0 HATCH|91 1|92 0|93 1|72 2|10 10|20 10|40 5|50 " + std::string(from) + "|51 0|73 1|97 0|"); },
        "more than a thousand turns");
  expect_refused(
      [] { dxf("0 INSERT|2 b|10 0|20 0|70 1048576|71 1048576|", {}, "4", "0 BLOCK|2 b|10 0|20 0|0 ENDBLK|"); },
      "more than a million blocks");
}

TEST(ReadDxf, AByteOrderMarkIsPassedOver) {
  Context context;
  EXPECT_EQ(read_dxf("\xEF\xBB\xBF" + dxf_text(kSquare, "4"), "f.dxf", {}, context)->kind, Shape::Kind::kRings);
}

TEST(ReadDxf, NamesOfCodePagesBecomeUtf8) {
  FileChoice choice;
  choice.layer = "Größe €";
  const std::string circle = "|10 5|20 5|40 2|";
  EXPECT_EQ(dxf(kSquare +
                    "0 CIRCLE|8 Gr\xF6\xDF"
                    "e \x80" +
                    circle,
                choice)
                ->kind,
            Shape::Kind::kDisc);
  EXPECT_EQ(dxf(kSquare + "0 CIRCLE|8 Größe €" + circle, choice)->kind, Shape::Kind::kDisc);
  EXPECT_EQ(dxf(kSquare + "0 CIRCLE|8 Gr\\U+00F6\\U+00DFe \\U+20AC" + circle, choice)->kind, Shape::Kind::kDisc);
}

TEST(ReadDxf, BlocksAndLayers) {
  const char* block = "0 BLOCK|2 part|10 1|20 1|0 CIRCLE|8 0|10 1|20 1|40 2|0 ENDBLK|";
  ShapePtr disc = dxf("0 INSERT|8 holes|2 part|10 30|20 40|41 3|42 3|50 90|", {}, "4", block);
  EXPECT_EQ(disc->points[0], (GridPoint{30, 40}));
  EXPECT_EQ(disc->amount.integer(), exact::int128(6));
  FileChoice choice;
  choice.layer = "holes";
  EXPECT_EQ(dxf(kSquare + "0 INSERT|8 holes|2 part|10 30|20 40|", choice, "4", block)->kind, Shape::Kind::kDisc);
  EXPECT_EQ(dxf("0 INSERT|2 part|10 30|20 40|70 3|71 2|44 9|45 9|", {}, "4", block)->children.size(), 6u);
  EXPECT_EQ(dxf("0 INSERT|2 part|10 30|20 40|230 -1|", {}, "4", block)->points[0], (GridPoint{-30, 40}));
  FileChoice second;
  second.index = 1;
  EXPECT_EQ(dxf(kSquare + "0 LWPOLYLINE|70 1|10 50|20 0|10 60|20 0|10 60|20 9|", second)->contours[0].size(), 3u);
}

}  // namespace io_read_drawings
}  // namespace findspace::io
