// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// DXF and GeoJSON read back as the set that was written.
#include <gtest/gtest.h>

#include <random>

#include "findspace/error.h"
#include "io/export/write_drawing.h"
#include "io/read/read_file.h"
#include "plane/build/build.h"
#include "plane/query/summary.h"
#include "plane_topology_sets.h"

namespace findspace::io {
namespace io_write_drawing {

using exact::Real;
using plane::Region;

std::string dxf(const Region& s, DxfVersion version = DxfVersion::kR12) {
  const NamedRegion named{"part 1", &s};
  return shapes_dxf({&named, 1}, Real(1), formula::Unit::kMillimetre, version).text;
}

std::string geojson(const Region& s) {
  const NamedRegion named{"a", &s};
  return shapes_geojson({&named, 1}, Real(1)).text;
}

/// On a grid of steps of 1.
ReadContext context() {
  ReadContext c;
  c.grid = Grid(Real(1));
  c.unit = Unit::kMillimetre;
  c.drawing.open_lines = true;
  return c;
}

Region from_dxf(const std::string& text, FileChoice choice = {}) {
  ReadContext c = context();
  return plane::build(*read_dxf(text, "t.dxf", choice, c)).region;
}

Region from_geojson(const std::string& text) {
  ReadContext c = context();
  return plane::build(*read_geojson(text, "t.geojson", {}, c)).region;
}

TEST(WriteDrawing, RefusesAndSaysWhatIsLost) {
  EXPECT_THROW(dxf(Region::uniform(1)), Error);
  EXPECT_THROW(geojson(Region::uniform(1)), Error);
  EXPECT_THROW(geojson(plane::disc(0, 0, Real(5))), Error);
  const Region open = interior(plane::box(0, 0, 4, 4));
  const NamedRegion named{"a", &open};
  EXPECT_FALSE(shapes_dxf({&named, 1}, Real(1), {}).lost.empty());
  EXPECT_FALSE(shapes_geojson({&named, 1}, Real(1)).lost.empty());
}

TEST(WriteDrawing, PartsReadBack) {
  const Region box = plane::box(0, 0, 30, 20);
  for (const Region& s : {box, plane::disc(3, 4, Real(5)), plane::disc(3, 4, Real::ratio(5, 2)),
                          box - interior(plane::disc(10, 10, Real(5))), box + plane::disc(30, 10, Real(10)),
                          plane::disc(0, 0, Real(5)) & plane::box(-9, 0, 9, 9),
                          plane::disc(0, 0, Real(25)) - interior(plane::box(-7, -7, 7, 7)),
                          box + plane::box(30, 20, 40, 40), box + plane::point(50, 5)})
    for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::k2000})
      EXPECT_TRUE(same_set(from_dxf(dxf(s, version)), s)) << dxf(s, version);
  const Region with_segment = box + plane::segment({30, 10}, {40, 17});
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::k2000})
    EXPECT_TRUE(same_set(from_dxf(dxf(with_segment, version)), with_segment));
}

TEST(WriteDrawing, ALineThatIsMissingPartsNoAreas) {
  const Region whole = plane::box(0, 0, 30, 20), square = plane::box(5, 5, 9, 9);
  for (const Region& s : {whole - boundary(square), whole - boundary(plane::disc(10, 10, Real(5))),
                          whole - plane::segment({0, 0}, {30, 20})})
    for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::k2000})
      EXPECT_TRUE(same_set(from_dxf(dxf(s, version)), whole)) << dxf(s, version);
  EXPECT_TRUE(same_set(from_geojson(geojson(whole - boundary(square))), whole));
}

TEST(WriteDrawing, LinesThatGoRoundHaveNoInside) {
  const auto lost = [](const Region& s) {
    const NamedRegion named{"a", &s};
    return shapes_dxf({&named, 1}, Real(1), {}).lost;
  };
  const Region open = plane::segment({0, 0}, {9, 0}) + plane::segment({9, 0}, {9, 5}) + plane::segment({9, 5}, {4, 0});
  EXPECT_NE(lost(boundary(plane::disc(0, 0, Real(5)))).find("no inside, as those of 'a': lost"), std::string::npos);
  EXPECT_NE(lost(open).find("no inside"), std::string::npos);
  EXPECT_EQ(lost(open - plane::segment({4, 0}, {9, 0})), lost(interior(plane::box(0, 0, 1, 1))));
}

/// By bulges of their own these arcs would be off by hundreds of steps.
TEST(WriteDrawing, ArcsOfNearlyAFullCircleAreDivided) {
  for (const int y : {123, -77, 3}) {
    const Region s = plane::disc(0, 0, Real(100003)) - interior(plane::box(90000, y, 110000, y + 50));
    const plane::Summary was = plane::summarize(s, Real(1)), is = plane::summarize(from_dxf(dxf(s)), Real(1));
    EXPECT_NEAR(*was.area, *is.area, 3 * 2 * 3.15 * 100003 + 3 * 20000) << dxf(s);
    for (const int k : {0, 1}) {
      EXPECT_NEAR(was.bbox->low[k], is.bbox->low[k], 3);
      EXPECT_NEAR(was.bbox->high[k], is.bbox->high[k], 3);
    }
  }
}

TEST(WriteDrawing, LayersAreShapes) {
  const Region a = plane::box(0, 0, 3, 3), b = plane::box(9, 0, 12, 3);
  const NamedRegion named[] = {{"left side", &a}, {"b", &b}};
  const std::string text = shapes_dxf(named, Real(1), formula::Unit::kMillimetre).text;
  FileChoice choice;
  choice.layer = "left_side";
  EXPECT_TRUE(same_set(from_dxf(text, choice), a));
  EXPECT_TRUE(same_set(from_dxf(text), a + b));
  const NamedRegion odd[] = {{"\u00fc \u6f22", &a}, {"\u00d1", &b}, {"part", &a}, {"Part", &b}};
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::k2000}) {
    const bool kept = version == DxfVersion::k2000;
    for (const auto& [name, region] :
         {std::pair{kept ? "\u00fc \u6f22" : "___", &a}, {kept ? "\u00d1" : "_", &b}, {"part", &a}, {"Part_2", &b}}) {
      choice.layer = name;
      EXPECT_TRUE(same_set(from_dxf(shapes_dxf(odd, Real(1), {}, version).text, choice), *region)) << name;
    }
  }
  choice.layer = "left side";
  EXPECT_TRUE(same_set(from_dxf(shapes_dxf(named, Real(1), {}, DxfVersion::k2000).text, choice), a));
}

TEST(WriteDrawing, RandomRegionsReadBack) {
  std::mt19937 random(7);
  auto pick = [&](int most) { return std::int64_t(random() % unsigned(most)); };
  for (int round = 0; round < 60; ++round) {
    Region polygonal = Region::uniform(0), round_set = Region::uniform(0);
    for (int k = 0; k < 6; ++k) {
      const std::int64_t x = pick(40), y = pick(40);
      const Region box = plane::box(x, y, x + 1 + pick(12), y + 1 + pick(12));
      polygonal = k % 3 == 2 ? closure(interior(polygonal - box)) : polygonal + box;
      // Whole circles on the grid, apart from each other, or on the corners of boxes along the axes.
      round_set = round_set + plane::disc(60 * k, 0, Real(1 + pick(20)));
    }
    const Region both = polygonal + round_set;
    EXPECT_TRUE(same_set(from_geojson(geojson(regularize(polygonal))), regularize(polygonal)));
    if (regularize(both).faces.empty()) continue;
    EXPECT_TRUE(same_set(from_dxf(dxf(round_set)), round_set));
    EXPECT_TRUE(same_set(from_dxf(dxf(regularize(polygonal))), regularize(polygonal)));
  }
}

}  // namespace io_write_drawing
}  // namespace findspace::io
