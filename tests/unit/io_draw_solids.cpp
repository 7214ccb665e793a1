// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pictures of space: slices of a region, and solids at a position.
#include <gtest/gtest.h>

#include <algorithm>

#include "io/draw/draw_bodies.h"
#include "io/draw/draw_slices.h"
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
  const std::string svg = slices_svg(
      {"a < b", "", "mm", "positions", grid, low, high, 0.5, space::all_rows(rays), {space::all_rows(small)}});
  EXPECT_EQ(count(svg, "class=\"layer\""), 8);
  EXPECT_EQ(count(svg, "face strips"), 6);
  EXPECT_EQ(count(svg, "fixed strips"), 2);
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
  BodiesPicture picture{"a & b", "mm", {"one line"}, {{&box, {}, false}, {&ball, {1, 0, 0}, true}}, {}, 0.5};
  picture.pairs.push_back({{{0, 0, 0}, {1, 1, 1}}});
  const std::string svg = bodies_svg(picture);
  EXPECT_NE(svg.find("a &amp; b"), std::string::npos);
  EXPECT_EQ(count(svg, "<circle"), 2);
  EXPECT_EQ(count(svg, "class=\"witness\""), 1);
  const std::size_t dashed = svg.find("stroke-dasharray");
  const std::string hidden = svg.substr(dashed, svg.find("/>", dashed) - dashed);
  EXPECT_EQ(std::count(hidden.begin(), hidden.end(), 'M'), 3);
}

}  // namespace io_draw_solids
}  // namespace findspace::io
