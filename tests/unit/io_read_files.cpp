// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// WKT and GeoJSON: bad input first. Units of files.
#include <gtest/gtest.h>

#include <chrono>

#include "findspace/error.h"
#include "io/read/read_file.h"

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
}  // namespace findspace::io
