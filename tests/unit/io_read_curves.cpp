// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Drawings with curves beyond arcs: areas against closed forms, the side of the arcs, and the ways to draw the same.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "findspace/error.h"
#include "io/read/read_file.h"
#include "io/scene/scene.h"
#include "io/text/drawing_rules.h"
#include "io/text/quantity.h"
#include "plane/build/build.h"
#include "plane/query/summary.h"

namespace findspace::io {
namespace io_read_curves {

using exact::Real;
using std::numbers::pi;

/// Millimetres on the usual grid.
struct Context : ReadContext {
  explicit Context(CurveRule rule = CurveRule::kNear) {
    unit = Unit::kMillimetre;
    drawing.curves = rule;
  }
};

double area(const plane::ShapePtr& shape) {
  return plane::summarize(plane::build(*shape).region, Real::ratio(1, 1000000)).area.value();
}

double svg_area(const std::string& inside, CurveRule rule = CurveRule::kNear) {
  Context context(rule);
  return area(read_svg("<svg width='100mm' viewBox='0 0 100 100'>" + inside + "</svg>", "f.svg", {}, context));
}

/// The area, which arcs change by less than the tolerance times the perimeter, and on the side that is asked for.
void expect_svg(const std::string& inside, double wanted, double perimeter) {
  EXPECT_NEAR(svg_area(inside), wanted, perimeter / 1000);
  EXPECT_LE(svg_area(inside, CurveRule::kInside), wanted);
  EXPECT_GE(svg_area(inside, CurveRule::kInside), wanted - perimeter / 1000);
  EXPECT_GE(svg_area(inside, CurveRule::kOutside), wanted);
  EXPECT_LE(svg_area(inside, CurveRule::kOutside), wanted + perimeter / 1000);
}

TEST(ReadCurves, SvgAreas) {
  expect_svg("<ellipse cx='50' cy='40' rx='30' ry='10' transform='rotate(30)'/>", 300 * pi, 140);
  expect_svg("<circle r='10' transform='scale(2, 1)'/>", 200 * pi, 100);
  expect_svg("<path d='M0 0 A20 10 0 0 1 40 0 Z'/>", 100 * pi, 90);
  expect_svg("<path d='M0 0 Q10 30 30 0 Z'/>", 30 * 30 / 3.0, 80);  // two thirds of the triangle
  expect_svg("<path d='M0 0 C0 40 40 40 40 0 Z'/>", 40 * 40 * 0.6, 120);
  expect_svg("<rect width='40' height='20' rx='6' ry='3'/>", 800 - 18 * (4 - pi), 120);
  expect_svg("<path d='M0 0 C0 40 40 40 40 0 Z M18 10 A2 4 0 0 0 22 10 A2 4 0 0 0 18 10'/>", 960 - 8 * pi, 160);
}

/// A square of 10 with one of 4 in it, drawn by two elements of this look.
double area_of_two(const std::string& look, ReadContext& context, const FileChoice& choice = {}) {
  const std::string drawing = "<svg width='100mm' viewBox='0 0 100 100'><style>.cut {fill: none}</style><g id='g' " +
                              look + "><rect width='10' height='10'/><path d='M3 3 H7 V7 H3 Z'/></g></svg>";
  return area(read_svg(drawing, "f.svg", choice, context));
}

TEST(ReadCurves, OutlinesWithoutAFillNest) {
  for (const char* look : {"fill='none'", "style='stroke: red; fill: none'", "class='cut'"}) {
    Context context;
    EXPECT_EQ(area_of_two(look, context), 84) << look;
    ASSERT_EQ(context.notes.size(), 1u);
    EXPECT_NE(context.notes[0].find("that lie in others are holes"), std::string::npos);
    FileChoice second;
    second.index = 1;
    EXPECT_EQ(area_of_two(look, context, second), 16);
    context.drawing.parts = PartRule::kElements;
    EXPECT_EQ(area_of_two(look, context), 100);
    EXPECT_EQ(context.notes.size(), 1u);
  }
  Context context;
  EXPECT_EQ(area_of_two("fill='red'", context), 100);
  EXPECT_EQ(area_of_two("", context), 100);
  EXPECT_TRUE(context.notes.empty());
  context.drawing.parts = PartRule::kOne;
  EXPECT_EQ(area_of_two("", context), 84);
}

TEST(ReadCurves, OutlinesThatCrossAreAreas) {
  Context context;
  EXPECT_EQ(area(read_svg("<svg width='9mm' viewBox='0 0 9 9' fill='none'><path d='M0 0 H4 V4 H0 Z'/>"
                          "<path d='M3 3 H6 V6 H3 Z'/><path d='M1 1 H2 V2 H1 Z'/></svg>",
                          "f.svg", {}, context)),
            24);
  ASSERT_EQ(context.notes.size(), 1u);
  EXPECT_NE(context.notes[0].find("cross or are open"), std::string::npos);
}

TEST(ReadCurves, OutlinesBesideEachOtherKeepTheirNames) {
  Context context;
  const plane::ShapePtr shape = read_svg(
      "<svg width='9mm' viewBox='0 0 9 9' fill='none'><path id='a' d='M0 0 H9 V1 H1 V9 H0 Z M0.2 0.2 H0.8 V0.8 H0.2 "
      "Z'/>"
      "<circle id='b' cx='5' cy='5' r='2'/></svg>",
      "f.svg", {}, context);  // b is in the box of a alone
  ASSERT_EQ(shape->children.size(), 2u);
  EXPECT_EQ(shape->children[0]->name, "a");
  EXPECT_EQ(shape->children[1]->name, "b");
  EXPECT_TRUE(context.notes.empty());
}

std::string dxf_text(const std::string& entities) {
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  bool code = true;
  for (char c : entities) {
    if (c == '|') code = true;
    const bool blank = c == ' ' && code;
    if (blank) code = false;
    text += c == '|' || blank ? '\n' : c;
  }
  return text + "0\nENDSEC\n0\nEOF\n";
}

TEST(ReadCurves, OutlinesOfDxfAreParts) {
  const auto square = [](const std::string& layer, int x, int side) {
    const auto line = [&](int x0, int y0, int x1, int y1) {
      return "0 LINE|8 " + layer + "|10 " + std::to_string(x0) + "|20 " + std::to_string(y0) + "|11 " +
             std::to_string(x1) + "|21 " + std::to_string(y1) + "|";
    };
    return line(x, 0, x + side, 0) + line(x + side, 0, x + side, side) + line(x + side, side, x, side) +
           line(x, side, x, 0);
  };
  const std::string text =
      dxf_text(square("plate_x2", 0, 9) + "0 CIRCLE|8 holes|10 4.5|20 4.5|40 4|" + square("0", 20, 3));
  Context context;
  context.quantities = true;
  const plane::ShapePtr all = read_dxf(text, "f.dxf", {}, context);
  ASSERT_EQ(all->children.size(), 2u);
  EXPECT_EQ(all->children[0]->name, "plate_x2");
  EXPECT_NEAR(area(all->children[0]), 81 - 16 * pi, 1e-4);
  EXPECT_EQ(all->children[1]->name, "");
  EXPECT_EQ(area(all->children[1]), 9);
}

TEST(ReadCurves, HatchesHaveTheNamesOfTheirLayers) {
  const auto hatch = [](const std::string& layer, const std::string& x, const std::string& to) {
    return "0 HATCH|8 " + layer + "|70 1|91 1|92 2|72 0|73 1|93 3|10 " + x + "|20 0|10 " + to + "|20 0|10 " + to +
           "|20 5|97 0|";
  };
  Context context;
  context.quantities = true;
  const plane::ShapePtr all =
      read_dxf(dxf_text(hatch("plate_x2", "0", "5") + hatch("lid_x3", "10", "15")), "f.dxf", {}, context);
  ASSERT_EQ(all->children.size(), 2u);
  EXPECT_EQ(all->children[0]->name, "plate_x2");
  EXPECT_EQ(all->children[1]->name, "lid_x3");
}

TEST(ReadCurves, NamesSayHowMany) {
  EXPECT_EQ(quantity_in("bracket x12")->name, "bracket");
  EXPECT_EQ(quantity_in("bracket x12")->count, 12);
  EXPECT_EQ(quantity_in("top plate - X3")->name, "top plate");
  EXPECT_EQ(quantity_in("a_x0")->count, 0);
  for (const char* other : {"", "x", "x3", " x3", "box3", "max3", "bracket x", "bracket x1234567",
                            "bracket x99999999999", "bracket x3 ", "12"})
    EXPECT_FALSE(quantity_in(other)) << other;
}

TEST(ReadCurves, TangentialCusps) {
  const std::string drop = "<path d='M50 10 C50 40 80 50 80 70 A30 30 0 0 1 20 70 C20 50 50 40 50 10 Z'/>";
  const std::string lens = "<path d='M10 50 C40 50 60 40 90 50 C60 60 40 50 10 50 Z'/>";
  expect_svg(drop, 1620 + 450 * pi, 250);
  expect_svg(lens, 390, 180);
  // Both sides of the tip are within the tolerance of each other there: arcs cross, and that is said.
  Context context;
  read_svg("<svg width='100mm' viewBox='0 0 100 100'>" + drop + "</svg>", "f.svg", {}, context);
  ASSERT_EQ(context.notes.size(), 1u);
  EXPECT_NE(context.notes[0].find("outlines cross in 1 place, the longest 0.08"), std::string::npos)
      << context.notes[0];
}

TEST(ReadCurves, UseSymbolsAndViews) {
  const std::string defs =
      "<defs><rect id='r' width='4' height='5'/><symbol id='s' viewBox='0 0 10 10'><rect width='10' "
      "height='10'/></symbol></defs>";
  EXPECT_NEAR(svg_area(defs + "<use href='#r' x='3'/>"), 20, 1e-3);
  EXPECT_NEAR(svg_area(defs + "<use xlink:href='#r' transform='scale(2)'/>"), 80, 1e-3);
  EXPECT_NEAR(svg_area(defs + "<use href='#s' width='20' height='40'/>"), 400, 1e-3);
  EXPECT_NEAR(svg_area("<svg x='5' width='20' height='20' viewBox='0 0 10 10'><rect width='1' height='2'/></svg>"), 8,
              1e-3);
  EXPECT_NEAR(svg_area("<svg width='20' height='40' viewBox='0 0 10 10' preserveAspectRatio='none'><circle "
                       "r='3'/></svg>"),
              9 * pi * 8, 0.1);
}

TEST(ReadCurves, ColoursAreLayers) {
  const std::string drawing =
      "<svg><style>.cut { stroke: #F00; } #x{stroke:blue} .off{display:none}</style><rect class='cut' width='2' "
      "height='3'/><rect id='x' width='4' height='3'/><g stroke='rgb(0, 128, 0)'><rect width='5' height='3'/></g>"
      "<rect class='off' stroke='red' width='50' height='3'/></svg>";
  auto of = [&](const char* layer) {
    Context context;
    FileChoice choice;
    choice.layer = layer;
    return area(read_svg(drawing, "f.svg", choice, context));
  };
  EXPECT_NEAR(of("red"), 6, 1e-6);
  EXPECT_NEAR(of("#0000ff"), 12, 1e-6);
  EXPECT_NEAR(of("green"), 15, 1e-6);
  EXPECT_THROW(of("yellow"), Error);
}

double dxf_area(const std::string& text, CurveRule rule = CurveRule::kNear) {
  Context context(rule);
  return area(read_dxf(text, "f.dxf", {}, context));
}

const std::string kEllipse = "0 ELLIPSE|10 5|20 6|11 20|21 10|40 0.5|41 0.0|42 6.283185307|";
const std::string kSpline =
    "0 SPLINE|70 0|71 3|40 0|40 0|40 0|40 0|40 1|40 1|40 1|40 1|10 0|20 0|10 0|20 40|10 40|20 40|10 40|20 0|0 LINE|10 "
    "0|20 0|11 40|21 0|";

TEST(ReadCurves, DxfAreas) {
  EXPECT_NEAR(dxf_area(dxf_text(kEllipse)), 250 * pi, 0.1);
  EXPECT_LE(dxf_area(dxf_text(kEllipse), CurveRule::kInside), 250 * pi);
  EXPECT_GE(dxf_area(dxf_text(kEllipse), CurveRule::kOutside), 250 * pi);
  EXPECT_NEAR(dxf_area(dxf_text("0 ELLIPSE|10 5|20 6|11 20|21 0|40 0.5|41 0.0|42 3.141592653589793|0 LINE|10 25|20 "
                                "6|11 -15|21 6|")),
              100 * pi, 0.1);
  EXPECT_NEAR(dxf_area(dxf_text(kSpline)), 40 * 40 * 0.6, 0.1);
  EXPECT_NEAR(dxf_area(dxf_text("0 SOLID|10 0|20 0|11 4|21 0|12 0|22 3|13 4|23 3|")), 12, 1e-6);
}

TEST(ReadCurves, HatchesAreReadAlone) {
  const std::string square =
      "0 HATCH|10 0|20 0|30 0|2 SOLID|91 2|92 2|72 1|73 1|93 4|10 0|20 0|42 0|10 20|20 0|42 0|10 "
      "20|20 20|42 0|10 0|20 20|42 0|97 0|92 0|93 1|72 2|10 10|20 10|40 5|50 0|51 360|73 1|97 0|";
  EXPECT_NEAR(dxf_area(dxf_text(square)), 400 - 25 * pi, 1e-6);
  const std::string mixed =
      "0 HATCH|91 1|92 0|93 3|72 1|10 0|20 0|11 40|21 0|72 3|10 20|20 0|11 20|21 0|40 0.5|50 0|51 90|73 1|72 1|10 "
      "20|20 "
      "10|11 0|21 0|97 0|";
  EXPECT_NEAR(dxf_area(dxf_text(mixed)), 50 * pi + 100, 0.1);
  Context context;
  read_dxf(dxf_text(square + "0 CIRCLE|10 0|20 0|40 5|"), "f.dxf", {}, context);
  EXPECT_EQ(context.notes.at(0), "f.dxf: 1 HATCH left out");
  EXPECT_THROW(dxf_area(dxf_text("0 HATCH|91 1|92 2|72 0|73 1|93 4|10 0|20 0|")), Error);
}

/// The groups of an ASCII file as a binary one.
std::string binary(const std::string& ascii) {
  std::string out("AutoCAD Binary DXF\r\n\x1a\0", 22);
  auto put = [&](auto value) { out.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (std::size_t at = 0; at < ascii.size();) {
    const std::size_t first = ascii.find('\n', at), second = ascii.find('\n', first + 1);
    const int code = std::stoi(ascii.substr(at, first - at));
    const std::string value = ascii.substr(first + 1, second - first - 1);
    put(static_cast<std::uint16_t>(code));
    if (code >= 10 && code < 60)
      put(std::stod(value));
    else if (code >= 60 && code < 80)
      put(static_cast<std::int16_t>(std::stoi(value)));
    else
      out += value + '\0';
    at = second + 1;
  }
  return out;
}

TEST(ReadCurves, BinaryDxfIsTheSame) {
  for (const std::string& entities : {kEllipse, kSpline}) {
    const std::string text = dxf_text(entities);
    EXPECT_EQ(dxf_area(binary(text)), dxf_area(text));
    const std::string cut = binary(text);
    EXPECT_THROW(dxf_area(cut.substr(0, cut.size() / 2)), Error);
  }
}

double scene_area(const std::string& shape) {
  const Scene scene = read_scene_text(R"({"findspace": 1, "unit": "mm", "shapes": {"a": )" + shape + "}}", ".", "s");
  return area(scene.shapes.at(0));
}

TEST(ReadCurves, ScenesSayTheSame) {
  EXPECT_NEAR(scene_area(R"({"ellipse": {"center": [5, 5], "radii": [30, 10], "rotate": 30}})"), 300 * pi, 0.1);
  EXPECT_NEAR(scene_area(R"({"ellipse": {"center": [5, 5], "radii": [3, 3]}})"), 9 * pi, 1e-6);
  EXPECT_NEAR(scene_area(R"({"bezier": [[0, 0], [0, 40], [40, 40], [40, 0], [0, 0]]})"),
              scene_area(R"({"outline": [[0, 0], {"bezier": [[0, 40], [40, 40], [40, 0], [0, 0]]}]})"), 1e-9);
  EXPECT_NEAR(scene_area(R"({"path": "M0 0 C0 40 40 40 40 0 Z", "curves": "outside", "tolerance": "0.01mm"})"), 960,
              1.2);
  EXPECT_GT(scene_area(R"({"path": "M0 0 C0 40 40 40 40 0 Z", "curves": "outside", "tolerance": 0.01})"), 960);
  EXPECT_NEAR(scene_area(R"({"outline": [[0, 0], [10, 0], {"through": [15, 5], "to": [10, 10]}, [0, 10]]})"),
              100 + 12.5 * pi, 1e-6);
  EXPECT_NEAR(scene_area(R"({"outline": [[0, 0], [10, 0], {"center": [10, 5], "to": [10, 10]}, [0, 10]]})"),
              100 + 12.5 * pi, 1e-6);
  EXPECT_NEAR(scene_area(R"({"outline": [[0, 0], [10, 0], {"bulge": -1, "to": [10, 10]}, [0, 10]]})"), 100 - 12.5 * pi,
              1e-6);
  EXPECT_NEAR(scene_area(R"({"outline": [[7, 0], {"center": [0, 0], "to": [7, 0], "ccw": false}],
                            "holes": [[[2, 0], {"center": [0, 0], "to": [2, 0]}]]})"),
              45 * pi, 1e-6);
  EXPECT_NEAR(
      scene_area(R"({"spline": {"degree": 2, "points": [[0, 0], [10, 0], [10, 10], [0, 10]], "closed": true}})"),
      100 - 4 * 12.5 / 3, 0.05);
  for (const char* wrong : {R"({"outline": [[0, 0], {"center": [1, 0], "to": [3, 3]}]})",
                            R"({"ellipse": {"center": [0, 0], "radii": [1, 0]}})", R"({"bezier": [[0, 0]]})",
                            R"({"spline": {"points": [[0, 0], [1, 1]]}})", R"({"outline": [[0, 0]]})",
                            R"({"path": "M0 0 C0 4 4 4 4 0 Z", "tolerance": 1e-9})",
                            R"({"path": "M0 0 C0 4 4 4 4 0 Z", "curves": "left"})"})
    EXPECT_THROW(scene_area(wrong), Error) << wrong;
}

TEST(ReadCurves, AStepOfAnOutlineGoesOneWay) {
  const auto fault = [](const std::string& step) {
    try {
      scene_area(R"({"outline": [[0, 0], [10, 0], )" + step + "]}");
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(fault(R"({"to": [0, 10], "bezier": [[12, 3], [10, 5]]})").find("\"bezier\" and \"to\" do not go together"),
            std::string::npos);
  EXPECT_NE(fault(R"({"to": [10, 10], "through": [15, 5], "bulge": 0.1})").find("\"through\" and \"bulge\" do not"),
            std::string::npos);
  EXPECT_NE(fault(R"({"to": [10, 10], "ccw": false})").find("\"ccw\" has no meaning in a straight step"),
            std::string::npos);
  EXPECT_NE(fault(R"({"to": [10, 10], "bulge": 0.1, "weights": [1, 2]})").find("\"bulge\" and \"weights\" do not"),
            std::string::npos);
  const std::string apart = fault(R"({"to": [10, 10], "center": [3, 3]})");  // one place, the innermost
  EXPECT_EQ(apart.find("shape 'a', step 2 ("), 0u) << apart;
  EXPECT_EQ(apart.find("shape 'a'", 1), std::string::npos) << apart;
}

std::string refusal(const std::string& shape) {
  try {
    scene_area(shape);
  } catch (const Error& e) {
    return e.message();
  }
  return {};
}

TEST(ReadCurves, HolesOfAnOutlineLieInItsRing) {
  const auto with = [](const std::string& holes) {
    return R"({"outline": [[0, 0], [10, 0], [10, 10], [0, 10]], "holes": [)" + holes + "]}";
  };
  const std::string square = "[[2, 2], [6, 2], [6, 6], [2, 6]]", curved = R"([[2, 2], {"bezier": [[9, 2], [2, 9]]}])";
  EXPECT_NEAR(scene_area(with("")), 100, 1e-9);
  EXPECT_NEAR(scene_area(with(square)), 84, 1e-9);
  EXPECT_NEAR(scene_area(with(curved)), 100 - 49 / 3.0, 0.02);
  EXPECT_EQ(refusal(with("[[20, 0], [25, 0], [25, 5], [20, 5]]")).find("hole 0 is not inside the ring"), 0u);
  EXPECT_NE(refusal(with("[[-5, -5], [15, -5], [15, 15], [-5, 15]]")), "");
  EXPECT_NE(refusal(with(square + ", [[3, 3], [5, 3], [5, 5], [3, 5]]")), "");
  EXPECT_NE(refusal(with("[[10, 0], [15, 0], [15, 5], [10, 5]]")), "");
  EXPECT_NE(refusal(with(R"([[20, 0], {"bezier": [[25, 0], [20, 5]]}])")), "");
}

TEST(ReadCurves, NoJoinIsAdvisedThatLeavesNothing) {
  const std::string why = refusal(R"({"outline": [[0, 0], {"bezier": [[3, -0.02], [7, -0.02], [10, 0]]},
                                                  {"bezier": [[7, 0.02], [3, 0.02], [0, 0]]}], "tolerance": 0.1})");
  EXPECT_NE(why.find("of curves within 0.1 mm: a smaller tolerance may help"), std::string::npos) << why;
  EXPECT_EQ(why.find("--join"), std::string::npos) << why;
}

const std::string kLens = R"([[0, 0], {"bezier": [[3, -0.02], [7, -0.02], [10, 0]]},
                                      {"bezier": [[7, 0.02], [3, 0.02], [0, 0]]}])";
constexpr double kLensArea = 0.204;

std::string on_side(const std::string& shape, const char* side, const char* tolerance) {
  return "{" + shape + R"(, "curves": ")" + side + R"(", "tolerance": )" + tolerance + "}";
}

TEST(ReadCurves, WhatIsThinnerThanTheToleranceStaysOnItsSide) {
  const std::string lens = R"("outline": )" + kLens,
                    slit = R"("outline": [[-5, -5], [15, -5], [15, 5], [-5, 5]], "holes": [)" + kLens + "]";
  const auto expect = [](const std::string& shape, double area) {
    EXPECT_LE(scene_area(on_side(shape, "inside", "0.0001")), area);
    EXPECT_GE(scene_area(on_side(shape, "outside", "0.0001")), area);
    EXPECT_NEAR(scene_area(on_side(shape, "inside", "0.0001")), area, 0.01);
    EXPECT_NEAR(scene_area(on_side(shape, "outside", "0.0001")), area, 0.01);
  };
  expect(lens, kLensArea);
  expect(slit, 200 - kLensArea);
  EXPECT_NE(refusal(on_side(lens, "inside", "0.1")).find("thinner than the tolerance, 0.1 mm"), std::string::npos);
  const std::string eight =
      R"("outline": [[-10, 0], {"bezier": [[-10, 20], [10, -20], [10, 0]]}, {"bezier": [[10, 20], [-10, -20], [-10, 0]]}])";
  EXPECT_NE(refusal(on_side(eight, "inside", "0.1")).find("crosses itself"), std::string::npos);
  EXPECT_NEAR(scene_area(on_side(lens, "outside", "0.1")), 1, 0.3);
  EXPECT_NEAR(scene_area(on_side(slit, "outside", "0.1")), 200, 1e-9);  // the slit is closed
  EXPECT_NEAR(scene_area(on_side(slit, "inside", "0.1")), 199, 0.3);
  // At this tolerance the chain near the curve runs the other way round.
  const std::string half = R"("outline": [[0, 0], [10, 0], {"bezier": [[7, 0.02], [3, 0.02], [0, 0]]}])";
  EXPECT_NEAR(scene_area(on_side(half, "outside", "0.1")), 0.5, 0.2);
  const Scene scene =
      read_scene_text(R"({"findspace": 1, "shapes": {"a": )" + on_side(half, "outside", "0.1") + "}}", ".", "s");
  const plane::Bounds box =
      plane::summarize(plane::build(*scene.shapes.at(0)).region, Real::ratio(1, 1000000)).bbox.value();
  EXPECT_EQ(box.low[1], 0);
  EXPECT_GT(box.high[1], 0.015);
  EXPECT_NE(refusal(on_side(half, "inside", "0.1")), "");
}

TEST(ReadCurves, WallsThinnerThanTheToleranceAreRefused) {
  const std::string ring =
      "M8 3 A10 5 0 0 1 -8 -3 A10 5 0 0 1 8 3 Z M-9.98 0 A9.98 4.98 0 0 0 9.98 0 A9.98 4.98 0 0 0 -9.98 0 Z";
  const double area = (50 - 9.98 * 4.98) * pi;
  const auto path = [](const std::string& d) { return R"("path": ")" + d + '"'; };
  EXPECT_NE(refusal(on_side(path(ring), "inside", "0.1")), "");
  EXPECT_GE(scene_area(on_side(path(ring), "outside", "0.1")), area);
  EXPECT_LE(scene_area(on_side(path(ring), "inside", "0.0001")), area);
  EXPECT_NEAR(scene_area(on_side(path(ring), "inside", "0.0001")), area, 0.01);
  const std::string around = "M-20 -20 H20 V20 H-20 Z " + ring;
  EXPECT_NE(refusal(on_side(path(around), "outside", "0.1")), "");
  EXPECT_LE(scene_area(on_side(path(around), "inside", "0.1")), 1600 - area);
}

TEST(ReadCurves, SimplifiedThinShapesStayOnTheirSide) {
  std::string lens;  // of 40 segments
  for (int k = 0; k < 40; ++k)
    lens += (k > 0 ? ", [" : "[") + std::to_string(k < 20 ? 0.5 * k : 20 - 0.5 * k) + ", " +
            std::to_string(-0.03 * std::sin(pi * k / 20)) + "]";
  const auto simple = [&](const char* side, const char* tolerance, const std::string& of) {
    return R"({"simplify": )" + std::string(tolerance) + R"(, "curves": ")" + side + R"(", "of": )" + of + "}";
  };
  const std::string alone = R"({"polygon": [)" + lens + "]}",
                    plate = R"({"polygon": [[-5, -5], [15, -5], [15, 5], [-5, 5]], "holes": [[)" + lens + "]]}";
  EXPECT_NEAR(scene_area(simple("outside", "1", plate)), 200, 1e-9);
  EXPECT_NEAR(scene_area(simple("outside", "0.1", plate)), 200, 1e-9);  // two segments there and back
  EXPECT_NE(refusal(simple("inside", "0.1", alone)), "");
  EXPECT_GE(scene_area(simple("outside", "0.001", plate)), scene_area(plate));
  EXPECT_LE(scene_area(simple("inside", "0.001", alone)), scene_area(alone));
}

TEST(ReadCurves, MirroredInALine) {
  const std::string part = R"({"outline": [[0, 0], [10, 0], {"to": [10, 10], "bulge": 0.5}, [0, 4]]})";
  auto box = [](const std::string& shape) {
    const Scene scene = read_scene_text(R"({"findspace": 1, "shapes": {"a": )" + shape + "}}", ".", "s");
    return plane::summarize(plane::build(*scene.shapes.at(0)).region, Real::ratio(1, 1000000)).bbox.value();
  };
  const plane::Bounds was = box(part), down = box(R"({"mirror": 0, "of": )" + part + "}");
  EXPECT_NEAR(down.low[1], -was.high[1], 1e-9);
  EXPECT_NEAR(down.high[0], was.high[0], 1e-9);
  const plane::Bounds left = box(R"({"mirror": 90, "about": [2, 0], "of": )" + part + "}");
  EXPECT_NEAR(left.low[0], 4 - was.high[0], 1e-9);
  EXPECT_NEAR(left.high[1], was.high[1], 1e-9);
  EXPECT_NEAR(scene_area(R"({"mirror": 30, "about": [2, 7], "of": )" + part + "}"), scene_area(part), 1e-4);
  EXPECT_NEAR(scene_area(R"({"point_reflection": )" + part + "}"), scene_area(part), 1e-9);
  EXPECT_THROW(scene_area(R"({"mirror": 30})"), Error);
  EXPECT_THROW(scene_area(R"({"mirror": )" + part + R"(, "about": [5, 0]})"), Error);
}

/// A wheel of short segments with a square hole, and the name of its shape.
std::string wheel() {
  std::string ring;
  for (int k = 0; k < 400; ++k) {
    const double r = 30 + 2 * std::cos(k * pi / 40), angle = k * pi / 200;
    ring +=
        (k > 0 ? ", [" : "[") + std::to_string(r * std::cos(angle)) + ", " + std::to_string(r * std::sin(angle)) + "]";
  }
  return R"({"polygon": [)" + ring + R"(], "holes": [[[-5, -5], [5, -5], [5, 5], [-5, 5]]]})";
}

TEST(ReadCurves, SimplifiesOnASide) {
  const double exact_area = scene_area(wheel());
  auto simple = [](const char* side) {
    return R"({"simplify": "0.05mm", "curves": ")" + std::string(side) + R"(", "of": )" + wheel() + "}";
  };
  EXPECT_NEAR(scene_area(simple("near")), exact_area, 0.05 * 260);
  EXPECT_GE(scene_area(simple("outside")), exact_area);
  EXPECT_LE(scene_area(simple("outside")), exact_area + 0.05 * 260);
  EXPECT_LE(scene_area(simple("inside")), exact_area);
  EXPECT_GE(scene_area(simple("inside")), exact_area - 0.05 * 260);
  const Scene scene =
      read_scene_text(R"({"findspace": 1, "unit": "mm", "shapes": {"a": )" + simple("near") + "}}", ".", "s");
  const auto& contours = scene.shapes.at(0)->contours;
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_LT(contours[0].size(), 80u);
  EXPECT_EQ(contours[1].size(), 4u);  // corners stay
  const auto by_rule = [&](const std::string& rule, const std::string& beside, std::optional<CurveRule> given) {
    ReadOptions options;
    options.drawings.curves = given;
    const std::string shape = R"({"simplify": "0.05mm", "of": )" + wheel() + beside + "}";
    return area(read_scene_text(R"({"findspace": 1, "unit": "mm", )" + rule + R"("shapes": {"a": )" + shape + "}}", ".",
                                "s", options)
                    .shapes.at(0));
  };
  const std::string outside = R"("curves": "outside", )";
  EXPECT_EQ(by_rule(outside, "", {}), scene_area(simple("outside")));
  EXPECT_EQ(by_rule(outside, R"(, "curves": "inside")", {}), scene_area(simple("inside")));
  EXPECT_EQ(by_rule(outside, R"(, "curves": "outside")", CurveRule::kInside), scene_area(simple("inside")));
  EXPECT_THROW(scene_area(R"({"simplify": 0.1, "of": {"hull": )" + wheel() + "}}"), Error);
  EXPECT_THROW(scene_area(R"({"simplify": [], "of": )" + wheel() + "}"), Error);
}

TEST(ReadCurves, TheUsualGridSuitsLargeNumbers) {
  auto step = [](const std::string& numbers) {
    const std::string text = R"({"findspace": 1, "shapes": {"a": {"points": )" + numbers + "}}}";
    return read_scene_text(text, ".", "s").grid.step();
  };
  EXPECT_EQ(compare(step("[[3.5, 1]]"), Real::ratio(1, 1000000)), 0);
  EXPECT_EQ(compare(step("[[1099511, 1.25]]"), Real::ratio(1, 1000000)), 0);
  EXPECT_EQ(compare(step("[[3000000, 1.25]]"), Real::ratio(1, 10000)), 0);
  EXPECT_EQ(compare(step("[[3e10, 1]]"), Real(1)), 0);
  EXPECT_THROW(step("[[3000000, 1.123456]]"), Error);  // a digit would be lost
}

TEST(ReadCurves, UnitsAsPeopleSpellThem) {
  const Scene scene =
      read_scene_text(R"({"findspace": 1, "unit": "inch", "shapes": {"a": {"points": [[1, 1]]}}})", ".", "s");
  EXPECT_EQ(scene.unit, Unit::kInch);
  EXPECT_EQ(parse_unit("mils"), Unit::kMil);
  EXPECT_EQ(compare(parse_length("5 mils", Unit::kInch), Real::ratio(5, 1000)), 0);
  EXPECT_THROW(parse_length("5 miles", Unit::kInch), Error);
  EXPECT_THROW(parse_length("5mm", std::nullopt), Error);
}

}  // namespace io_read_curves
}  // namespace findspace::io
