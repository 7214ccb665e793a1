// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets whose rings touch themselves, their holes or each other in points, written as SVG and WKT, read back as the same
// sets: lattice cells in which corners meet, triangles cut out corner to corner, discs that touch at lattice points.
// Rings that run along or through each other by more than a rounding are refused.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "io/export/write_wkt.h"
#include "io/read/read_file.h"
#include "io/write/write_svg.h"
#include "law/plane_random.h"
#include "plane/build/touching_rings.h"
#include "plane/complex/primitives.h"
#include "plane/walk/unite.h"

namespace findspace::io {
namespace io_touching_rings {

using exact::Real;
using plane::GridPoint;
using plane::Mark;
using plane::Random;
using plane::Region;

ReadContext whole_steps() {
  ReadContext context;
  context.grid = Grid(Real(1));
  context.unit = formula::Unit::kMillimetre;
  return context;
}

constexpr std::int64_t kSide = 200;  // of a cell; arcs rise more than a step over their chords

Region ring(const std::vector<GridPoint>& points) {
  return plane::region_of_rings(std::array{plane::contour_of(points)});
}

/// Cells of a lattice, halves of cells and discs in cells, filled or left out.
Region random_set(Random& random, bool discs) {
  std::vector<Region> parts, cut;
  for (std::int64_t x = 0; x < 5 * kSide; x += kSide)
    for (std::int64_t y = 0; y < 5 * kSide; y += kSide) {
      const GridPoint low{x, y}, right{x + kSide, y}, top{x + kSide, y + kSide}, left{x, y + kSide};
      const Region disc = plane::region_of_disc(Real(x + kSide / 2), Real(y + kSide / 2), Real(kSide / 2));
      const auto kind = random.pick(discs ? 0 : 2, 5);
      if (kind == 1) cut.push_back(plane::interior(disc));
      if (kind == 2 && discs) parts.push_back(disc);
      if (kind == 3) parts.push_back(ring({low, right, left}));
      if (kind == 1 || kind > 3) parts.push_back(ring({low, right, top, left}));
    }
  std::vector<const Region*> all, holes;
  for (const Region& r : parts) all.push_back(&r);
  const Region whole = plane::unite(all);
  holes.push_back(&whole);
  for (const Region& r : cut) holes.push_back(&r);
  return plane::regularize(plane::subtract(holes));
}

/// Does a walk along the boundary come to a vertex twice?
bool touches_itself(const Region& r) {
  for (plane::Index v = 0; v < r.vertices.size(); ++v) {
    int around = 0;
    for (plane::Index h = r.vertices[v].out; h != plane::kNone;) {
      ++around;
      h = r.clockwise(h);
      if (h == r.vertices[v].out) break;
    }
    if (around > 2) return true;
  }
  return false;
}

TEST(TouchingRings, ReadBackAsTheSameSet) {
  Random random(5);
  int touching = 0;
  for (int round = 0; round < 150; ++round) {
    const bool discs = round % 2 == 0;
    const Region set = random_set(random, discs);
    if (plane::is_empty(set)) continue;
    touching += touches_itself(set);
    ReadContext context = whole_steps();
    const std::string svg = shape_svg(set, Real(1), "s", formula::Unit::kMillimetre).text;
    ASSERT_TRUE(same_set(plane::build(*read_svg(svg, "s.svg", {}, context)).region, set)) << svg;
    if (discs) continue;  // WKT gives arcs by points on the grid: they touch no longer
    const std::string wkt = region_wkt(set, Real(1)).text;
    ASSERT_TRUE(same_set(plane::build(*read_wkt(wkt, "s.wkt", {}, context)).region, set)) << wkt;
  }
  EXPECT_GT(touching, 100);
}

plane::ShapePtr path(const std::string& d) {
  ReadContext context = whole_steps();
  return read_svg(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20mm\" height=\"20mm\" viewBox=\"0 0 20 20\"><path d=\"" + d +
          "\"/></svg>",
      "s.svg", {}, context);
}

TEST(TouchingRings, ElsewhereTheyAreMended) {
  EXPECT_NO_THROW(path("M0 0H8V8H0Z M0 0L4 2L2 4Z"));
  // What is no larger than a rounding is mended: on this grid a corner on an edge, a short side along one, a small hole
  // that sticks out. unit/plane_mended_rings.cpp has larger ones.
  EXPECT_NO_THROW(path("M0 0H8V8H0Z M4 0L6 2L2 2Z"));
  EXPECT_NO_THROW(path("M0 0H8V8H0Z M0 0H4V4Z"));
  EXPECT_NO_THROW(path("M0 0H8V8H0Z M0 0L4 2L2 4Z M6 6H10V7H6Z"));
}

TEST(TouchingRings, HolesLieInTheirRing) {
  const auto contour = [](std::vector<GridPoint> points) { return plane::contour_of(points); };
  const auto outer = contour({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  const auto touching = [](std::vector<plane::Contour> rings) {
    return plane::region_of_touching_rings(rings, plane::RingRule::kHoles).has_value();
  };
  EXPECT_TRUE(touching({outer, contour({{0, 0}, {4, 2}, {2, 4}})}));
  EXPECT_TRUE(touching({outer, contour({{1, 1}, {4, 2}, {2, 4}}), contour({{4, 2}, {6, 2}, {6, 4}})}));
  EXPECT_FALSE(touching({outer, contour({{0, 0}, {-4, -2}, {-2, -4}})}));                                 // outside
  EXPECT_FALSE(touching({outer, contour({{0, 0}, {6, 1}, {1, 6}}), contour({{0, 0}, {3, 2}, {2, 3}})}));  // in a hole
  EXPECT_FALSE(touching({contour({{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}})}));  // twice at a corner
  EXPECT_FALSE(touching({outer}));                                                      // nothing touches
}

}  // namespace io_touching_rings
}  // namespace findspace::io
