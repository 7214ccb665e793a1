// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Points exactly as far from a segment as asked are not nearer, beside it, beyond its ends and on the border between
// the two; the smallest difference decides. Exact numbers are used only there.

#include <gtest/gtest.h>

#include "exact/number/stages.h"
#include "exact/planar/near_segment.h"

namespace findspace::exact {
namespace exact_near_segment {

const Real kLittle = Real::ratio(1, std::int64_t(1) << 62);

void expect_distance(const Geometry& g, std::uint32_t p, const GridSegment& s, const Real& d) {
  EXPECT_FALSE(is_nearer(g, p, s, d));
  EXPECT_FALSE(is_nearer(g, p, s, d - kLittle));
  EXPECT_TRUE(is_nearer(g, p, s, d + kLittle));
}

TEST(NearSegment, Grid) {
  Geometry g;
  const GridSegment s{0, 0, 10, 0};
  expect_distance(g, g.add_grid_point(3, 4), s, 4);
  expect_distance(g, g.add_grid_point(0, -4), s, 4);
  expect_distance(g, g.add_grid_point(10, 4), s, 4);
  expect_distance(g, g.add_grid_point(13, 4), s, 5);
  expect_distance(g, g.add_grid_point(-3, -4), s, 5);
  const auto on = g.add_grid_point(7, 0);
  EXPECT_TRUE(is_nearer(g, on, s, kLittle));
}

TEST(NearSegment, Slanted) {
  Geometry g;
  const GridSegment s{100, 50, 300, 450};  // direction (1, 2)
  const auto line = g.add(SupportingCurve::displaced_line(2, -1, 150, Real(3)));
  // Where the perpendiculars in the middle and at an end meet the displaced line.
  for (const int projection : {700, 1200, 200}) {
    const auto across = g.add_line(1, 2, projection);
    expect_distance(g, g.add_crossing(line, across, 0), s, 3);
  }
  // Where the displaced line leaves the circle of the same radius about an end, and a point further on.
  const auto circle = g.add(SupportingCurve::circle_at(300, 450, Real(3)));
  expect_distance(g, g.add_crossing(line, circle, 0), s, 3);
  const auto beyond = g.add_crossing(line, g.add_line(1, 2, 1205), 0);  // 5 / sqrt(5) past the projection of the end
  expect_distance(g, beyond, s, sqrt(Real(14)));
}

TEST(NearSegment, DoublesDecideWhatIsClear) {
  Geometry g;
  const GridSegment s{0, 0, 1000, 1001};
  const auto near = g.add_grid_point(500, 510), far = g.add_grid_point(-500, 510);
  stage_counts() = {};
  EXPECT_TRUE(is_nearer(g, near, s, 10));
  EXPECT_FALSE(is_nearer(g, far, s, 10));
  const StageCounts& c = stage_counts();
  EXPECT_EQ(c.fixed + c.quadratic + c.bigfloat + c.zero_bound, 0u);
}

}  // namespace exact_near_segment
}  // namespace findspace::exact
