// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <pugixml.hpp>

#include "findspace/error.h"
#include "findspace/scene.h"
#include "io/draw/draw_layout.h"
#include "io/read/read_file.h"
#include "io/write/write_svg.h"
#include "plane/build/build.h"
#include "plane_topology_sets.h"

namespace findspace::io {
namespace io_write_svg {

using exact::Real;
using plane::Region;

std::string picture_of(const Region& s, std::vector<NamedRegion> fixed = {}, std::vector<NamedRegion> moving = {}) {
  const plane::Summary summary = plane::summarize(s, Real(1));
  Picture p;
  p.title = "A < B & \"C\"";
  p.step = Real(1);
  p.unit = "mm";
  p.region = &s;
  p.summary = &summary;
  p.fixed = std::move(fixed);
  p.moving = std::move(moving);
  return picture_svg(p);
}

/// How many elements of a class the map has (not the legend).
int count(const std::string& svg, const char* style) {
  pugi::xml_document xml;
  EXPECT_TRUE(xml.load_string(svg.c_str()));
  int n = 0;
  for (const auto& node : xml.select_nodes("/svg/g/*"))
    n += std::string(node.node().attribute("class").value()) == style;
  return n;
}

TEST(Svg, EverySetIsWellFormed) {
  for (const Region& s : {Region::uniform(0), Region::uniform(1), plane::point(3, 4), plane::segment({0, 0}, {0, 9}),
                          plane::disc(0, 0, Real(5)), complement(plane::disc(0, 0, Real(5)))}) {
    pugi::xml_document xml;
    EXPECT_TRUE(xml.load_string(picture_of(s).c_str()));
    EXPECT_EQ(std::string(xml.child("svg").child("title").text().get()), "A < B & \"C\"");
  }
}

TEST(Svg, KindsOfCellsLookDifferent) {
  const std::string svg = picture_of((plane::box(0, 0, 9, 9) - plane::segment({0, 0}, {9, 0})) +
                                     plane::segment({9, 5}, {14, 5}) + plane::point(20, 0));
  for (const char* style : {"face", "closed", "open", "free", "point"}) EXPECT_EQ(count(svg, style), 1) << style;
  const std::string closed = picture_of(plane::box(0, 0, 9, 9));
  for (const char* style : {"open", "free", "point", "hollow", "full"}) EXPECT_EQ(count(closed, style), 0) << style;
}

TEST(Svg, SinglePointsThatDiffer) {
  EXPECT_EQ(count(picture_of(plane::box(0, 0, 9, 9) - plane::point(4, 4)), "hollow"), 1);
  EXPECT_EQ(count(picture_of(interior(plane::box(0, 0, 9, 9)) + plane::point(0, 0)), "full"), 1);
}

TEST(Svg, ArcsAreArcs) {
  const std::string svg = picture_of(plane::disc(0, 0, Real(5)));
  EXPECT_NE(svg.find('A', svg.find("class=\"face\" d=")), std::string::npos);
}

TEST(Svg, UnboundedIsSaid) {
  EXPECT_NE(picture_of(complement(plane::box(0, 0, 4, 4))).find("unbounded"), std::string::npos);
  EXPECT_EQ(picture_of(plane::box(0, 0, 4, 4)).find("unbounded"), std::string::npos);
}

TEST(Svg, SceneryHasNamesAndTheMovingShapeAPlace) {
  const Region sheet = plane::box(0, 0, 100, 100), part = plane::box(-2, -2, 2, 2);
  const std::string svg = picture_of(plane::box(20, 20, 80, 80), {{"sheet <1>", &sheet}}, {{"part", &part}});
  EXPECT_NE(svg.find(">sheet &lt;1&gt;</text>"), std::string::npos);
  EXPECT_EQ(count(svg, "moving"), 1);
  EXPECT_EQ(count(svg, "pole"), 1);
  EXPECT_NE(svg.find("at p = (50, 50)"), std::string::npos);
}

/// Each once, also where the formula names one beside the collection; the first part without a name has the list's.
TEST(Svg, ThePartsOfACollectionCarryTheirNames) {
  const findspace::Scene yard = findspace::Scene::json(
      R"({"findspace": 1, "moving": "B", "where": "gap(B, all) >= 0.5 and gap(B, wall) <= 3", "shapes": {
          "B": {"box": {"min": [0, 0], "max": [1, 1]}}, "wall": {"box": {"min": [4, 0], "max": [6, 8]}},
          "post": {"box": {"min": [0, 5], "max": [2, 7]}},
          "all": ["wall", "post", {"box": {"min": [8, 8], "max": [9, 9]}}]}})");
  const std::string svg = yard.map({}).file(".svg").text;
  for (const std::string name : {">wall<", ">post<", ">all<"}) {
    EXPECT_NE(svg.find(name), std::string::npos) << svg;
    EXPECT_EQ(svg.find(name), svg.rfind(name));
  }
}

/// Strips as close as a name is high: a name that may cross no line has no place but on the part.
TEST(Svg, ANameDoesNotHideASmallPart) {
  Region strips = plane::box(0, 0, 100, 1);
  for (int k = 1; k < 30; ++k) strips = strips + plane::box(0, 2 * k, 100, 2 * k + 1);
  strips = plane::translated(strips, {-50, -30});
  const Region part = plane::box(-1, -1, 1, 1);
  Picture p;
  p.step = Real(1);
  const plane::Summary summary = plane::summarize(strips, Real(1));
  p.region = &strips;
  p.summary = &summary;
  p.moving = {{"a part with a long name", &part}};
  p.position = {0, 0};
  const std::string svg = picture_svg(p);
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(svg.c_str()));
  const auto name = xml.select_node("//text[@class='label']").node();
  ASSERT_STREQ(name.text().get(), "a part with a long name");
  double x = 0, y = 0;
  ASSERT_EQ(std::sscanf(xml.select_node("/svg/g/*[@class='moving']").node().attribute("d").value(), "M%lf %lf", &x, &y),
            2);
  EXPECT_GT(std::hypot(name.attribute("x").as_double() - x, name.attribute("y").as_double() - y), 14);
}

TEST(Svg, ArrowsSayHowShapesMove) {
  const Region moving = plane::box(-1, -1, 1, 1);
  Picture p;
  p.step = Real(1);
  p.moving = {{"B", &moving}};
  p.position = {4, 0};
  EXPECT_EQ(count(picture_svg(p), "arrow"), 0);
  p.arrows = {{Arrow::Kind::kWay, {{0, 0}, {10, 0}, {10, 0}, {10, 5}}, true}, {Arrow::Kind::kBothWays, {{0, 1}}, true}};
  const std::string svg = picture_svg(p);
  EXPECT_EQ(count(svg, "arrow"), 2);
  for (const char* text : {"way in time", "direction of the distance"}) EXPECT_NE(svg.find(text), std::string::npos);
  EXPECT_EQ(svg.find(">turn<"), std::string::npos);
  // The way is in the frame, each leg with a head, a leg of no length without.
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(svg.c_str()));
  const pugi::xml_node frame = xml.child("svg").child("clipPath").child("rect");
  const double right = frame.attribute("x").as_double() + frame.attribute("width").as_double();
  const std::string way = xml.select_node("/svg/g/path[@class='arrow']").node().attribute("d").value();
  EXPECT_EQ(std::count(way.begin(), way.end(), 'M'), 4);
  EXPECT_LT(std::stod(way.substr(way.find('L') + 1)), right);
  p.position.reset();
  p.of_positions = false;
  EXPECT_EQ(count(picture_svg(p), "arrow"), 0);
}

TEST(Svg, DistancesAreDimensionLines) {
  const Region none = Region::uniform(0), box = plane::box(0, 0, 9, 4);
  const plane::Summary summary = plane::summarize(none, Real(1));
  Picture p;
  p.step = Real(1);
  p.region = &none;
  p.summary = &summary;
  p.of_positions = false;
  p.fixed = {{"A", &box}};
  p.moving = {{"B", &box}};
  p.position = {20, 0};
  p.nearest = {14, 0};
  p.nearest_text = "nearest";
  const DimensionLine fails{{9, 2}, {20, 2}, "11", true}, same{{20, 2}, {9, 2}, "11", false};
  const DimensionLine meets{{9, 4}, {9, 4}, "0", false};
  p.dimensions = without_repetition({same, fails, meets});
  ASSERT_EQ(p.dimensions.size(), 2u);
  const std::string svg = picture_svg(p);
  EXPECT_EQ(count(svg, "dimension fails"), 1);
  EXPECT_EQ(count(svg, "dimension fails end"), 2);
  EXPECT_EQ(count(svg, "dimension"), 1) << "a ring, where two places are one";
  EXPECT_EQ(count(svg, "nearest"), 1);
  p.nearest.reset();
  p.dimensions.clear();
  for (const char* style : {"dimension", "dimension fails", "nearest"}) EXPECT_EQ(count(picture_svg(p), style), 0);
}

TEST(Svg, TicksOfWhatIsFarAwayEnd) {
  for (const double x : {0.0, 1e12, -1e16}) {
    const Frame frame = fit({{x, x}, {x + 0.001, x}}, 0.1, 0, 0);
    EXPECT_TRUE(std::isfinite(frame.scale));
    const double width = frame.world.high[0] - frame.world.low[0];
    EXPECT_GT(width, 0);
    const std::vector<double> marks = ticks(frame.world.low[0], frame.world.high[0], round_length(width / 8));
    EXPECT_GE(marks.size(), 8u);
    EXPECT_LE(marks.size(), 24u);
  }
}

TEST(Svg, ShapesReadBack) {
  for (const Region& s : {plane::box(0, 0, 9, 4), plane::box(0, 0, 30, 30) - interior(plane::box(5, 5, 9, 9)),
                          plane::box(-10, -10, 10, 10) & plane::disc(0, 0, Real(10))}) {
    ReadContext context;
    context.grid = Grid(Real(1));
    context.unit = Unit::kMillimetre;
    const DrawingText drawing = shape_svg(s, Real(1), "s", Unit::kMillimetre);
    EXPECT_TRUE(drawing.lost.empty());
    EXPECT_TRUE(same_set(plane::build(*read_svg(drawing.text, "test.svg", {}, context)).region, s)) << drawing.text;
  }
}

TEST(Svg, ShapesSayWhatIsLost) {
  EXPECT_FALSE(shape_svg(plane::point(1, 1), Real(1), "s", {}).lost.empty());
  EXPECT_FALSE(shape_svg(interior(plane::box(0, 0, 4, 4)), Real(1), "s", {}).lost.empty());
  EXPECT_THROW(shape_svg(Region::uniform(1), Real(1), "s", {}), Error);
}

}  // namespace io_write_svg
}  // namespace findspace::io
