// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pictures of space: slices of a region, and solids at a position.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "io/draw/draw_bodies.h"
#include "io/draw/draw_layout.h"
#include "io/draw/draw_slices.h"
#include "io/draw/space_names.h"
#include "space/rays/piece_rays.h"
#include "unit/space_bodies.h"

namespace findspace::io {
namespace io_draw_solids {

using exact::Real;
using space::RayGrid;

std::ptrdiff_t count(const std::string& text, const std::string& what) {
  std::ptrdiff_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// A ball of radius 3 about the origin: the outer layers are smaller, and beyond it there is none.
TEST(DrawSlices, OfABall) {
  const space::Point low{-4, -4, -4}, high{4, 4, 4};
  const RayGrid grid = slice_grid(low, high, 8, 16);
  EXPECT_EQ(grid.nv, 8);
  EXPECT_EQ(grid.axis, 0);
  const space::PieceRays rays({space::ball_piece({}, Real(3))}, 1, grid);
  const space::PieceRays small({space::ball_piece({}, Real(1))}, 1, grid);
  const std::string svg = slices_svg({"a < b",
                                      "",
                                      "mm",
                                      "positions",
                                      grid,
                                      low,
                                      high,
                                      0.5,
                                      space::all_rows(rays),
                                      {{"knob", space::all_rows(small)}}});
  EXPECT_EQ(count(svg, "class=\"layer\""), 8);
  EXPECT_EQ(count(svg, "face strips"), 6);
  EXPECT_EQ(count(svg, "class=\"section\""), 2);
  EXPECT_EQ(count(svg, ">knob</text>"), 2);  // in each layer that cuts it
  EXPECT_EQ(count(svg, "class=\"axis\""), 8);
  EXPECT_NE(svg.find("fixed shapes, cut at this height"), std::string::npos);
  EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  EXPECT_NE(svg.find("z = -0.25 mm"), std::string::npos);
  const std::size_t last = svg.rfind("face strips"),
                    middle = svg.rfind("face strips", svg.rfind("face strips", last - 1) - 1);
  const auto strips = [&](std::size_t from) {
    const std::string path = svg.substr(from, svg.find("/>", from) - from);
    return std::count(path.begin(), path.end(), 'M');
  };
  // Strips of half a step: |y| < sqrt(9 - z^2) at z = 2.5 and 0.5.
  EXPECT_EQ(strips(last), 6);
  EXPECT_EQ(strips(middle), 12);
}

TEST(DrawSlices, PlacesAreDots) {
  const space::Point low{-4, -4, -4}, high{4, 4, 4};
  RayGrid grid = slice_grid(low, high, 1, 1);
  grid.u = grid.v = 0;
  const space::PieceRays rays({space::ball_piece({}, Real())}, 1, grid);
  EXPECT_EQ(count(slices_svg({"", "", "", "", grid, low, high, 1, space::all_rows(rays), {}}), "free dots"), 1);
}

TEST(DrawBodies, OutlinesAndHiddenLines) {
  const space::Body box = space::box_body({{{{0, 0, 0}, {4, 4, 4}}}});
  space::Body ball;
  ball.parts.push_back({std::nullopt, {9, 9, 9}, Real(2)});
  BodiesPicture picture{"a & b", "mm", {"one line"}, {{"crate", &box}, {"bulb", &ball}}, {}, 0.5};
  picture.bodies[1].by = {1, 0, 0};
  picture.bodies[1].role = BodiesPicture::Role::kMoving;
  picture.pairs.push_back({{{{0, 0, 0}, {1, 1, 1}}}, "1.73 mm", true});
  const std::string svg = bodies_svg(picture);
  EXPECT_NE(svg.find("a &amp; b"), std::string::npos);
  EXPECT_EQ(count(svg, "<circle"), 2);
  EXPECT_EQ(count(svg, "class=\"witness\""), 1);
  for (const char* text : {">crate<", ">bulb<", ">1.73 mm<", ">x, mm<"}) EXPECT_EQ(count(svg, text), 1) << text;
  const std::size_t dashed = svg.find("stroke-dasharray");
  const std::string hidden = svg.substr(dashed, svg.find("/>", dashed) - dashed);
  EXPECT_EQ(std::count(hidden.begin(), hidden.end(), 'M'), 3);
}

/// Of surfaces, as of a body with the same faces: three faces are seen, and three edges are hidden.
TEST(DrawBodies, Surfaces) {
  const std::vector<space::Point> corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0},
                                          {0, 0, 4}, {4, 0, 4}, {0, 4, 4}, {4, 4, 4}};
  std::vector<space::RaySolid> solids(1);
  solids[0].surface = space::triangles(space::Polytope::hull(corners));
  BodiesPicture picture{"box", "mm", {}, {}, {}};
  picture.bodies.emplace_back().solids = &solids;
  const std::string svg = bodies_svg(picture);
  EXPECT_EQ(count(svg, "fill-opacity"), 6);  // two triangles a face
  const std::size_t dashed = svg.find("stroke-dasharray");
  const std::string hidden = svg.substr(dashed, svg.find("/>", dashed) - dashed);
  EXPECT_EQ(std::count(hidden.begin(), hidden.end(), 'M'), 3);
}

/// Where names stand: their boxes never meet.
TEST(SpaceNames, DoNotMeet) {
  SpaceNames names({{0, 0}, {400, 300}});
  std::vector<NamedSolid> solids;
  for (int k = 0; k < 12; ++k) {
    const double x = 100 + 11 * k, y = 100 + 5 * (k % 3);
    solids.push_back(
        {"part " + std::to_string(k), {{x, y}, {x + 20, y}, {x + 20, y + 20}, {x, y + 20}}, {}, double(k)});
  }
  names.name(solids);
  std::vector<plane::Bounds> boxes;
  const std::string& svg = names.svg();
  for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
    const auto number = [&](const char* key) { return std::stod(svg.substr(svg.find(key, at) + std::strlen(key))); };
    const std::size_t begin = svg.find('>', at) + 1;
    const std::string text = svg.substr(begin, svg.find('<', begin) - begin);
    boxes.push_back(text_box({number(" x=\""), number(" y=\"") - 12.5 * 0.36}, text, 12.5));
  }
  EXPECT_EQ(boxes.size(), 12u);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(boxes_meet(boxes[i], boxes[j])) << i << " " << j;
}

/// Of a round mesh neither a black net nor one colour: faces of many shades, and few edges.
TEST(DrawBodies, FineMeshIsShaded) {
  constexpr int kAround = 40;
  DrawnSurface sphere{{{0, 0, 1}}, {}};
  const auto at = [](int ring, int k) { return 1 + (ring - 1) * kAround + k % kAround; };
  for (int ring = 1; ring < kAround / 2; ++ring)
    for (int k = 0; k < kAround; ++k) {
      const double up = 2 * M_PI * ring / kAround, turn = 2 * M_PI * k / kAround;
      sphere.vertices.push_back({std::sin(up) * std::cos(turn), std::sin(up) * std::sin(turn), std::cos(up)});
    }
  sphere.vertices.push_back({0, 0, -1});
  const int last = int(sphere.vertices.size()) - 1;
  for (int k = 0; k < kAround; ++k) {
    sphere.faces.push_back({0, at(1, k), at(1, k + 1)});
    sphere.faces.push_back({last, at(kAround / 2 - 1, k + 1), at(kAround / 2 - 1, k)});
    for (int ring = 1; ring + 1 < kAround / 2; ++ring)
      sphere.faces.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1)});
  }
  BodiesPicture picture{"ball", "mm", {}, {}, {}};
  picture.bodies.emplace_back().surface = &sphere;
  const std::string svg = bodies_svg(picture);
  std::set<std::string> shades;
  for (std::size_t f = svg.find("fill=\"#"); f != std::string::npos; f = svg.find("fill=\"#", f + 1))
    shades.insert(svg.substr(f, 14));
  EXPECT_GT(shades.size(), 20u);
  EXPECT_EQ(count(svg, "stroke-dasharray"), 0);
  const auto edges = count(svg, "<path stroke=\"#555\"");
  EXPECT_GT(edges, 10);  // the silhouette
  EXPECT_LT(edges, 3 * kAround);
}

}  // namespace io_draw_solids
}  // namespace findspace::io
