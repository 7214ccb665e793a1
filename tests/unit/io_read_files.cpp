// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// WKT and GeoJSON: bad input first. Units of files. What SVG draws where.
#include <gtest/gtest.h>

#include <array>
#include <chrono>

#include "findspace/error.h"
#include "io/read/read_file.h"
#include "plane/build/build.h"
#include "plane/query/summary.h"

namespace findspace::io {
namespace io_read_files {

using plane::GridPoint;
using plane::Shape;
using plane::ShapePtr;

using Reader = ShapePtr (*)(std::string_view, const std::string&, const FileChoice&, ReadContext&);

ShapePtr read(Reader reader, const char* text, FileChoice choice = {}) {
  ReadContext context;
  context.grid = Grid(1);
  return reader(text, "f", choice, context);
}

void expect_refused(Reader reader, const char* text, const std::string& words) {
  try {
    read(reader, text);
    ADD_FAILURE() << text;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << text << "\n" << e.what();
  }
}

TEST(ReadFile, Units) {
  ReadContext context;
  FileChoice choice;
  EXPECT_EQ(file_scale({}, "f", choice, context).integer(), exact::int128(1));
  EXPECT_TRUE(context.notes.empty());
  EXPECT_THROW(file_scale(exact::Real(1), "f", choice, context), Error);  // the scene has no unit
  context.unit = Unit::kCentimetre;
  EXPECT_EQ(compare(file_scale(exact::Real(25), "f", choice, context), exact::Real::ratio(5, 2)), 0);
  EXPECT_TRUE(context.notes.empty());
  EXPECT_EQ(file_scale({}, "f", choice, context).integer(), exact::int128(1));
  EXPECT_EQ(context.notes.at(0), "f states no unit: read as cm");
  choice.unit = Unit::kInch;
  EXPECT_EQ(compare(file_scale({}, "f", choice, context), exact::Real::ratio(254, 100)), 0);
}

TEST(ReadWkt, Refuses) {
  expect_refused(read_wkt, "", "no shape");
  expect_refused(read_wkt, "POLYGON", "the text ends where '(' is expected");
  expect_refused(read_wkt, "POLYGON((0 0, 4 0, 4 4, 0 0)", "f:1:29: the text ends where ')'");
  expect_refused(read_wkt, "POLYGON((0 0, 4 0, 4 4))", "a ring must end at its first point");
  expect_refused(read_wkt, "POLYGON((0 0, 4 0, 4 x))", "f:1:22: a number is expected");
  expect_refused(read_wkt, "POLYGON EMPTY", "an empty geometry");
  expect_refused(read_wkt, "POLYGON Z((0 0 0, 4 0 0, 4 4 0, 0 0 0))", "Z and M");
  expect_refused(read_wkt, "POLYGON((0 0 0, 4 0 0, 4 4 0, 0 0 0))", "a third coordinate");
  expect_refused(read_wkt, "POLYGON((0 0, 40 40, 40 0, 0 40, 0 0))", "touches or crosses itself");
  expect_refused(read_wkt, "POLYGON((0 0, 4 0, 0 0))", "no area");
  expect_refused(read_wkt, "POLYGN((0 0, 4 0, 4 4, 0 0))", "'POLYGN' is not a geometry");
  expect_refused(read_wkt, "\x01\x02 junk", "f:1:1");
  expect_refused(read_wkt, "CIRCULARSTRING(0 0, 1 1)", "odd number of points");
  expect_refused(read_wkt, "LINESTRING(0 0, 0 0)", "two different points");
  expect_refused(read_wkt, "COMPOUNDCURVE((0 0, 1 0), (2 0, 3 0))", "does not begin where");
  FileChoice choice;
  choice.layer = "a";
  EXPECT_THROW(read(read_wkt, "POINT(0 0)", choice), Error);
  choice.layer.reset();
  choice.index = 1;
  EXPECT_THROW(read(read_wkt, "POINT(0 0)", choice), Error);
}

TEST(ReadFile, PlacesOfATextAreThoseOfItsLines) {
  std::string text;
  for (int k = 0; k < 3000; ++k) text += k % 7 == 0 || (k > 1000 && k < 2100) ? 'x' : '\n';
  text += "end";
  const TextPlaces places(text, "f");
  std::size_t line = 1, column = 1;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    EXPECT_EQ(places.at(at), "f:" + std::to_string(line) + ":" + std::to_string(column));
    column = at < text.size() && text[at] == '\n' ? 1 : column + 1;
    line += column == 1 ? 1 : 0;
  }
  EXPECT_EQ(places.at(text.size() + 9), places.at(text.size()));
  EXPECT_EQ(TextPlaces("", "f").at(0), "f:1:1");
}

/// Each asks for its place, which must not be looked for from the beginning.
TEST(ReadWkt, ManyGeometriesTakeLinearTime) {
  std::string points;
  for (int k = 0; k < 100000; ++k) points += "POINT(1 2)\n";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(read(read_wkt, points.c_str())->children.size(), 100000u);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 5);  // each place counted from the beginning takes far longer
}

TEST(ReadWkt, AByteOrderMarkIsPassedOver) {
  EXPECT_EQ(read(read_wkt, "\xEF\xBB\xBFPOINT(3 -4)")->points, (std::vector<GridPoint>{{3, -4}}));
  expect_refused(read_wkt, "\xEF\xBB\xBFPOLYGON", "f:1:8: the text ends");
}

TEST(ReadWkt, Geometries) {
  EXPECT_EQ(read(read_wkt, "SRID=4326;POINT(3 -4)")->points, (std::vector<GridPoint>{{3, -4}}));
  EXPECT_EQ(read(read_wkt, "multipoint((1 2), (3 4))")->points.size(), 2u);
  EXPECT_EQ(read(read_wkt, "MULTIPOINT(1 2, 3 4)")->points.size(), 2u);
  ShapePtr line = read(read_wkt, "LINESTRING(0 0, 4 0, 4 4, 0 0)");
  EXPECT_EQ(line->kind, Shape::Kind::kPolyline);
  EXPECT_EQ(line->contours[0].size(), 4u);
  ShapePtr polygon = read(read_wkt, "POLYGON((0 0, 0 9, 9 9, 9 0, 0 0), (1 1, 2 1, 2 2, 1 1))");
  EXPECT_EQ(polygon->kind, Shape::Kind::kRings);
  EXPECT_EQ(polygon->contours.size(), 2u);
  EXPECT_EQ(polygon->contours[0].size(), 4u);
  EXPECT_EQ(read(read_wkt, "MULTIPOLYGON(((0 0,1 0,1 1,0 0)),((5 5,6 5,6 6,5 5)))")->children.size(), 2u);
  EXPECT_EQ(read(read_wkt, "GEOMETRYCOLLECTION(POINT(0 0), LINESTRING(1 1, 2 2))")->children.size(), 2u);
  EXPECT_EQ(read(read_wkt, "POINT(0 0)\nPOINT(1 1)\n")->children.size(), 2u);
  FileChoice second;
  second.index = 1;
  EXPECT_EQ(read(read_wkt, "POINT(0 0)\nPOINT(1 1)\n", second)->points[0], (GridPoint{1, 1}));
}

TEST(ReadWkt, Curves) {
  ShapePtr arc = read(read_wkt, "CIRCULARSTRING(5 0, 3 4, -5 0)");
  EXPECT_EQ(arc->kind, Shape::Kind::kPolyline);
  EXPECT_TRUE(arc->contours[0][0].arc);
  EXPECT_EQ(arc->contours[0][0].arc->r.integer(), exact::int128(5));
  ShapePtr half = read(read_wkt, "CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING(5 0, 0 5, -5 0), (-5 0, 5 0)))");
  EXPECT_EQ(half->kind, Shape::Kind::kRings);
  EXPECT_EQ(half->contours[0].size(), 2u);
  ShapePtr ring = read(read_wkt, "CURVEPOLYGON((-9 -9, 9 -9, 9 9, -9 9, -9 -9), CIRCULARSTRING(5 0, -5 0, 5 0))");
  ASSERT_EQ(ring->contours.size(), 2u);
  EXPECT_EQ(ring->contours[1].size(), 2u);
  EXPECT_TRUE(ring->contours[1][0].arc);
}

TEST(ReadGeoJson, Refuses) {
  expect_refused(read_geojson, "", "not JSON");
  expect_refused(read_geojson, "{}", "\"type\" is missing");
  expect_refused(read_geojson, R"({"type": "Polygn", "coordinates": []})", "'Polygn' is not a type");
  expect_refused(read_geojson, R"({"type": "Polygon", "coordinates": []})", "is empty");
  expect_refused(read_geojson, R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4]]]})",
                 "end at its first point");
  expect_refused(read_geojson, R"({"type": "Polygon", "coordinates": [[[0,0],[40,40],[40,0],[0,40],[0,0]]]})",
                 "crosses itself");
  expect_refused(read_geojson, R"({"type": "Point", "coordinates": [1,2,3]})", "not [x, y]");
  expect_refused(read_geojson, R"({"type": "Point", "coordinates": ["1",2]})", "f:1:35");
  expect_refused(read_geojson, R"({"type": "Feature", "geometry": 1})", "must be an object");
  expect_refused(read_geojson, R"({"type": "Feature", "geometry": null})", "no shape");
}

TEST(ReadGeoJson, FeaturesWithoutAGeometryAreLeftOut) {
  ReadContext context;
  context.grid = Grid(1);
  const ShapePtr shape = read_geojson(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": "nowhere", "geometry": null},
    {"type": "Feature", "id": "lake", "geometry": {"type": "Point", "coordinates": [1, 2]}}]})",
                                      "f", {}, context);
  EXPECT_EQ(shape->points.size(), 1u);
  EXPECT_EQ(context.notes, std::vector<std::string>{"f: 1 feature has no geometry, left out"});
}

TEST(ReadGeoJson, Features) {
  const char* text = R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": 7, "geometry": {"type": "Point", "coordinates": [1, 2]}},
    {"type": "Feature", "properties": {"name": "lake"}, "geometry":
      {"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,9],[0,0]], [[1,1],[2,2],[2,1],[1,1]]]}}]})";
  EXPECT_EQ(read(read_geojson, text)->children.size(), 2u);
  FileChoice choice;
  choice.id = "lake";
  EXPECT_EQ(read(read_geojson, text, choice)->contours.size(), 2u);
  choice.id = "7";
  EXPECT_EQ(read(read_geojson, text, choice)->points[0], (GridPoint{1, 2}));
  choice.id = "lakes";
  EXPECT_THROW(read(read_geojson, text, choice), Error);
  ShapePtr all = read(read_geojson, R"({"type": "GeometryCollection", "geometries": [
    {"type": "MultiPoint", "coordinates": [[0,0],[1,1]]}, {"type": "LineString", "coordinates": [[0,0],[1,1]]},
    {"type": "MultiLineString", "coordinates": [[[0,0],[1,1]],[[2,2],[3,3]]]},
    {"type": "MultiPolygon", "coordinates": [[[[0,0],[1,0],[1,1],[0,0]]]]}]})");
  EXPECT_EQ(all->children.size(), 4u);
}

}  // namespace io_read_files

// What SVG draws where: visibility, styles by their specificity, transforms of styles, views, conditions.
namespace io_read_svg_looks {

using exact::Real;

const std::string kPage = "width='100mm' height='100mm' viewBox='0 0 100 100'";

struct Read {
  double area = 0;
  std::array<double, 4> box{};  // low and high corner, y upwards
  std::vector<std::string> notes;
};

Read read(const std::string& inside, const std::string& page = kPage, const FileChoice& choice = {}) {
  ReadContext context;
  context.grid = Grid(Real::ratio(1, 1000000));
  context.unit = Unit::kMillimetre;
  const plane::ShapePtr shape =
      read_svg("<svg xmlns='http://www.w3.org/2000/svg' " + page + ">" + inside + "</svg>", "f.svg", choice, context);
  const plane::Region region = plane::build(*shape, context.grid.step_size()).region;
  const plane::Summary found = plane::summarize(region, context.grid.step());
  const plane::Bounds box = found.bbox.value();
  return {found.area.value(), {box.low[0], box.low[1], box.high[0], box.high[1]}, context.notes};
}

std::string refusal(const std::string& inside, const std::string& page = kPage) {
  try {
    read(inside, page);
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

/// A square of side 10 at (x, 0) to (x + 10, 10) of the picture.
std::string square(int x, const std::string& more) {
  return "<rect x='" + std::to_string(x) + "' width='10' height='10' " + more + "/>";
}

void expect_box(const std::string& inside, const std::array<double, 4>& wanted, const std::string& page = kPage) {
  const Read found = read(inside, page);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found.box[k], wanted[k], 1e-5) << inside << ' ' << k;
}

TEST(SvgLooks, WhatIsNotVisibleIsNotRead) {
  const std::string seen = "<rect y='50' width='1' height='1'/>";
  const std::string style = "<style>.off {visibility: hidden}</style>";
  for (const char* look : {"visibility='hidden'", "style='visibility:collapse'", "class='off'"})
    EXPECT_DOUBLE_EQ(read(style + seen + square(0, look)).area, 1) << look;
  const std::string group = "<g visibility='hidden'>" + square(0, "") + square(20, "visibility='visible'") + "</g>";
  EXPECT_DOUBLE_EQ(read(group).area, 100);
  EXPECT_DOUBLE_EQ(read("<g display='none'>" + square(0, "display='inline'") + "</g>" + seen).area, 1);
  FileChoice asked;
  asked.id = "a";
  EXPECT_DOUBLE_EQ(read(square(0, "id='a' visibility='hidden'") + seen, kPage, asked).area, 100);
}

TEST(SvgLooks, RulesBySpecificity) {
  const auto hidden = [](const std::string& rules, const std::string& more = "class='a b' id='i'") {
    return read("<style>" + rules + "</style><rect y='50' width='1' height='1'/><g class='g'><g>" + square(0, more) +
                "</g></g>")
               .area == 1;
  };
  EXPECT_TRUE(hidden("#i {display: none} .a {display: inline} rect {display: inline}"));
  EXPECT_TRUE(hidden(".a.b {display: none} .a {display: inline}"));
  EXPECT_FALSE(hidden(".a {display: none} .b {display: inline}"));
  EXPECT_TRUE(hidden(".a {display: none !important} #i {display: inline}"));
  EXPECT_FALSE(hidden(".a {display: none}", "class='a' style='display: inline'"));
  EXPECT_TRUE(hidden(".a {display: none !important}", "class='a' style='display: inline'"));
  EXPECT_TRUE(hidden(".g rect {display: none}"));
  EXPECT_TRUE(hidden("svg > .g .a {display: none}"));
  EXPECT_TRUE(hidden("svg > g > g > rect.b {display: none}"));
  EXPECT_FALSE(hidden("svg > rect, .g > rect {display: none}"));
  EXPECT_TRUE(hidden("@charset 'utf-8'; @font-face {font-family: x; src: url(a;b)} .a {display: none}"));
  EXPECT_TRUE(hidden("@media print {.b {display: inline}} @media screen {.a {display: none}}"));
  EXPECT_FALSE(hidden("@media print {.a {display: none}} .b {fill: red}"));
  EXPECT_TRUE(hidden("/* } */ .a /* .b */ {display: none}"));
}

TEST(SvgLooks, RulesThatAreNotReadAreTold) {
  const std::string note = "f.svg: 1 rule of <style> not read, the first of 'rect:first-child'";
  EXPECT_EQ(read("<style>rect:first-child {display: none}</style>" + square(0, "")).notes, std::vector{note});
  const std::string pointer = "<style>rect:hover {fill: red} rect:first-child {font: x} a::before {fill: red}</style>";
  EXPECT_TRUE(read(pointer + square(0, "")).notes.empty());
}

TEST(SvgLooks, TransformsOfStyles) {
  const auto moved = [](const std::string& style) { return square(60, "style='transform:" + style + "'"); };
  expect_box(moved("translate(0px,50px)"), {60, -60, 70, -50});
  expect_box(moved("translateX(1in) translateY(10px)"), {60 + 96, -20, 70 + 96, -10});
  expect_box(moved("rotate(90deg)"), {-10, -70, 0, -60});
  expect_box(moved("rotate(0.25turn)"), {-10, -70, 0, -60});
  expect_box(moved("rotate(100grad)"), {-10, -70, 0, -60});
  expect_box(moved("scale(2) translate(-60px)"), {0, -20, 20, 0});
  expect_box(moved("scaleX(50%)"), {30, -10, 35, 0});
  expect_box(moved("matrix(1, 0, 0, 1, 5, 6)"), {65, -16, 75, -6});
  expect_box(moved("skewX(45deg)"), {60, -10, 80, 0});
  expect_box(square(60, "transform='translate(7)' style='transform: none'"), {60, -10, 70, 0});
  EXPECT_NE(refusal(moved("translate(10, 5)")).find("'10' in the transform of a style"), std::string::npos);
  EXPECT_NE(refusal(moved("translate(50%)")), "");
  EXPECT_NE(refusal(moved("rotate3d(1, 1, 1, 45deg)")), "");
  EXPECT_NE(refusal(square(0, "style='rotate: 45deg'")).find("\"rotate\" of a style is not read"), std::string::npos);
  EXPECT_NE(refusal("<g style='transform: translate(5)'>" + square(0, "") + "</g>").find("<g> (f.svg"),
            std::string::npos);
  EXPECT_NE(refusal(square(0, ""), kPage + " transform='rotate(90)'").find("of the whole drawing"), std::string::npos);
}

TEST(SvgLooks, OriginsOfTransforms) {
  const auto turned = [](const std::string& origin) { return square(80, "transform='rotate(90)' " + origin); };
  expect_box(turned("transform-origin='85 5'"), {80, -10, 90, 0});
  expect_box(turned("style='transform-origin: 80px 0px'"), {70, -10, 80, 0});
  expect_box(turned("transform-origin='0 0'"), {-10, -90, 0, -80});
  expect_box(turned("transform-origin='center'"), {90, -90, 100, -80});
  expect_box(turned("transform-origin='bottom 50%'"), {140, -140, 150, -130});
  expect_box(square(80, "transform-origin='center' style='transform-box: fill-box'"), {80, -10, 90, 0});
  expect_box(square(80, "transform='translate(5 5)' style='transform-box: fill-box'"), {85, -15, 95, -5});
  EXPECT_NE(refusal(turned("style='transform-box: fill-box'")).find("\"transform-box\" of a style"), std::string::npos);
}

TEST(SvgLooks, SizesOfStyles) {
  expect_box("<rect width='1' height='1' style='width: 20px; height: 5mm; x: 3px'/>", {3, -5 * 960 / 254.0, 23, 0});
  EXPECT_NEAR(read("<style>circle {r: 10px}</style><circle cx='20' cy='20'/>").area, 100 * 3.14159265, 1e-4);
  expect_box("<path style='d: path(\"M0 0 H9 V4 Z\")'/>", {0, -4, 9, 0});
}

TEST(SvgLooks, SizesOfViewsInStylesAreRefused) {
  const std::string inner = "<rect width='9' height='4'/>";
  EXPECT_NE(refusal("<svg style='width: 5px'>" + inner + "</svg>").find("\"width\" of a style"), std::string::npos);
  EXPECT_NE(refusal("<svg style='x: 5px'>" + inner + "</svg>"), "");
  expect_box("<defs><g id='g'>" + inner + "</g></defs><use href='#g' style='x: 5px'/>", {5, -4, 14, 0});
}

TEST(SvgLooks, LinesWithoutLengthDrawNothing) {
  EXPECT_DOUBLE_EQ(read("<line/><path d='M3 3 L3 3'/>" + square(0, "")).area, 100);
}

TEST(SvgLooks, Percentages) {
  expect_box("<rect width='50%' height='25%'/>", {0, -25, 50, 0});
  EXPECT_NEAR(read("<circle cx='50%' cy='50%' r='10%'/>").area, 100 * 3.14159265, 1e-4);
  expect_box("<svg x='10%' width='50%' height='50%'><rect width='100%' height='10%'/></svg>", {10, -5, 60, 0});
  EXPECT_NE(refusal("<rect width='50%' height='5'/>", "").find("depends on the page"), std::string::npos);
}

TEST(SvgLooks, Views) {
  const std::string symbol = "<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>";
  expect_box(symbol + "<use href='#s'/>", {0, -100, 100, 0});  // as large as the view around
  expect_box(symbol + "<use href='#s' x='5' width='20' height='40'/>", {5, -30, 25, -10});
  expect_box(
      "<defs><svg id='s' width='1' height='1' viewBox='0 0 10 10'><rect width='10' height='10'/></svg></defs>"
      "<use href='#s' width='20' height='20'/>",
      {0, -20, 20, 0});
  expect_box("<svg viewBox='0 0 10 10' preserveAspectRatio='xMaxYMin'><rect width='10' height='5'/></svg>",
             {100, -50, 200, 0}, "viewBox='0 0 200 100'");
  EXPECT_NE(refusal("<svg viewBox='0 0 10 10'><rect width='10' height='5'/></svg>", "").find("depends on the page"),
            std::string::npos);
  EXPECT_DOUBLE_EQ(read("<svg width='0' height='5'>" + square(0, "") + "</svg>" + square(20, "")).area, 100);
  EXPECT_NE(refusal(square(0, ""), "width='200' height='100' viewBox='0 0 10 10' preserveAspectRatio='none'"), "");
}

TEST(SvgLooks, OfASwitchTheFirstIsDrawn) {
  EXPECT_DOUBLE_EQ(read("<switch>" + square(0, "") + square(20, "") + "</switch>").area, 100);
  const std::string foreign = "<switch><foreignObject requiredExtensions='x'/><g>" + square(0, "") + square(20, "") +
                              "</g>" + square(40, "") + "</switch>";
  EXPECT_DOUBLE_EQ(read(foreign).area, 200);
  EXPECT_DOUBLE_EQ(read("<switch><title>a</title><style>a{}</style>" + square(0, "") + "</switch>").area, 100);
  const Read spoken = read("<switch>" + square(0, "systemLanguage='de'") + square(20, "") + "</switch>");
  EXPECT_DOUBLE_EQ(spoken.box[0], 20);
  EXPECT_EQ(spoken.notes, std::vector<std::string>{"f.svg: 1 element for readers of one language left out"});
}

TEST(SvgLooks, ClipPathsAndMasksAreTold) {
  const std::string clip = "<clipPath id='c'><rect width='2' height='2'/></clipPath>";
  EXPECT_EQ(read(clip + "<g clip-path='url(#c)'>" + square(0, "") + square(20, "") + "</g>" + square(40, "")).notes,
            std::vector<std::string>{"f.svg: 2 elements have a clip-path or a mask, read whole"});
  EXPECT_EQ(read(square(0, "style='mask: url(#m)'")).notes,
            std::vector<std::string>{"f.svg: 1 element has a clip-path or a mask, read whole"});
  EXPECT_TRUE(read(square(0, "clip-path='none'")).notes.empty());
}

TEST(SvgLooks, HolesThatProgramsFillAreTold) {
  const auto notes = [](const std::string& d, const std::string& look = "") {
    return read("<path d='M0 0 H30 V30 H0 Z " + d + "' " + look + "/>").notes;
  };
  const std::string alike = "M5 5 H9 V9 H5 Z", against = "M5 5 V25 H25 V5 Z", island = "M8 8 V9 H9 V8 Z";
  EXPECT_EQ(notes(alike).size(), 1u);
  EXPECT_NE(notes(alike).at(0).find("1 element has holes that run the same way"), std::string::npos);
  EXPECT_TRUE(notes(alike, "fill-rule='evenodd'").empty());
  EXPECT_TRUE(notes(alike, "style='fill: none'").empty());
  EXPECT_TRUE(notes(against).empty());
  EXPECT_TRUE(notes(against + island).empty());  // around it they run once and back, and once again
  EXPECT_TRUE(notes("M40 0 H50 V9 H40 Z").empty());
}

TEST(SvgLooks, OtherNamesOfNamespaces) {
  ReadContext context;
  context.grid = Grid(1);
  const std::string drawing =
      "<n:svg xmlns:n='http://www.w3.org/2000/svg' xmlns:l='http://www.w3.org/1999/xlink' xmlns:k='x'><n:style>.o "
      "{display: none}</n:style><n:defs><n:rect id='r' width='4' height='5'/></n:defs><n:g k:label='cuts'><n:use "
      "l:href='#r'/></n:g><n:rect class='o' width='9' height='9'/></n:svg>";
  FileChoice cuts;
  cuts.layer = "cuts";
  EXPECT_EQ(read_svg(drawing, "f.svg", cuts, context)->contours.at(0).size(), 4u);
  EXPECT_EQ(read_svg(drawing, "f.svg", {}, context)->contours.at(0).size(), 4u);
}

}  // namespace io_read_svg_looks
}  // namespace findspace::io
