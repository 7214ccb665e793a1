// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "findspace/error.h"
#include "io/export/write_wkt.h"
#include "io/read/read_file.h"
#include "plane/build/build.h"
#include "plane_topology_sets.h"

namespace findspace::io {
namespace io_write_wkt {

using exact::Real;
using plane::Region;

std::string wkt(const Region& s) { return region_wkt(s, Real(1)).text; }

/// What the text means, read back on a grid of steps of 1.
Region read_back(const std::string& text) {
  ReadContext context;
  context.grid = Grid(Real(1));
  return plane::build(*read_wkt(text, "test.wkt", {}, context)).region;
}

TEST(Wkt, Empty) { EXPECT_EQ(wkt(Region::uniform(0)), "GEOMETRYCOLLECTION EMPTY\n"); }

TEST(Wkt, UnboundedIsRefused) {
  EXPECT_THROW(region_wkt(Region::uniform(1), Real(1)), Error);
  EXPECT_THROW(region_wkt(complement(plane::box(0, 0, 1, 1)), Real(1)), Error);
}

TEST(Wkt, Point) { EXPECT_EQ(wkt(plane::point(3, -4)), "POINT (3 -4)\n"); }

TEST(Wkt, Segment) { EXPECT_EQ(wkt(plane::segment({0, 0}, {3, 4})), "LINESTRING (0 0, 3 4)\n"); }

TEST(Wkt, BoxWithAHole) {
  Region s = plane::box(0, 0, 9, 9) - interior(plane::box(3, 3, 6, 6));
  EXPECT_EQ(wkt(s).substr(0, 9), "POLYGON (");
  EXPECT_TRUE(same_set(read_back(wkt(s)), s));
}

TEST(Wkt, DiscIsACurvePolygon) {
  Region s = plane::disc(0, 0, Real(5));
  EXPECT_EQ(wkt(s), "CURVEPOLYGON (CIRCULARSTRING (-5 0, 0 -5, 5 0, 0 5, -5 0))\n");
  EXPECT_TRUE(same_set(read_back(wkt(s)), s));
}

TEST(Wkt, HalfDiscIsACompoundCurve) {
  Region s = plane::disc(0, 0, Real(5)) & plane::box(-9, 0, 9, 9);
  EXPECT_NE(wkt(s).find("COMPOUNDCURVE ("), std::string::npos);
  EXPECT_NE(wkt(s).find("CIRCULARSTRING (5 0, 0 5, -5 0)"), std::string::npos);
  EXPECT_TRUE(same_set(read_back(wkt(s)), s));
}

TEST(Wkt, MixedSetIsACollection) {
  Region s = plane::box(0, 0, 4, 4) + plane::segment({4, 2}, {9, 2}) + plane::point(20, 0);
  EXPECT_EQ(wkt(s).substr(0, 19), "GEOMETRYCOLLECTION ");
  EXPECT_TRUE(same_set(read_back(wkt(s)), s));
}

TEST(Wkt, OpenEndsAreLostAndSaidToBe) {
  EXPECT_TRUE(region_wkt(plane::box(0, 0, 4, 4), Real(1)).lost.empty());
  WktText open = region_wkt(interior(plane::box(0, 0, 4, 4)), Real(1));
  EXPECT_FALSE(open.lost.empty());
  EXPECT_TRUE(same_set(read_back(open.text), plane::box(0, 0, 4, 4)));
}

TEST(Wkt, CracksAreNotPartOfRings) {
  Region filled = plane::box(0, 0, 9, 9);
  EXPECT_TRUE(same_set(read_back(wkt(filled - plane::segment({3, 3}, {6, 6}))), filled));
  EXPECT_TRUE(same_set(read_back(wkt(filled - plane::segment({3, 3}, {9, 3}))), filled));
  // A crack that joins a hole to the outside: two rings on one boundary cycle.
  Region holed = filled - interior(plane::box(3, 3, 6, 6));
  EXPECT_TRUE(same_set(read_back(wkt(holed - plane::segment({6, 4}, {9, 4}))), holed));
}

TEST(Wkt, RingsAreCutWhereTheyTouchThemselves) {
  // Two holes that meet in a corner, and a hole that touches the outer ring in one.
  Region s = plane::box(0, 0, 9, 9) - interior(plane::box(2, 2, 4, 4)) - interior(plane::box(4, 4, 6, 6));
  const std::string text = wkt(s);
  EXPECT_EQ(std::count(text.begin(), text.end(), '('), 4);
  Region t = plane::box(0, 0, 9, 9) - interior(plane::polygon({{9, 4}, {7, 6}, {5, 4}, {7, 2}}));
  const std::string touching = wkt(t);
  EXPECT_EQ(std::count(touching.begin(), touching.end(), '('), 3);
}

}  // namespace io_write_wkt
}  // namespace findspace::io
