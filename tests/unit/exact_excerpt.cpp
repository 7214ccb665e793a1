// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "exact/planar/excerpt.h"
#include "exact/planar/geometry_signs.h"

namespace findspace::exact {
namespace exact_excerpt {

/// Two circles that cross at (0, 4) and (0, -4), a line through both points, and points of every kind.
struct Whole {
  Geometry g;
  std::uint32_t left, right, line, upper, lower, on_line, real;
  Whole() {
    left = g.add(SupportingCurve::circle_at(-3, 0, Real(5)));
    right = g.add(SupportingCurve::circle_at(3, 0, Real(5)));
    line = g.add_line(1, 0, 0);
    const Meeting m = meet(g, left, right);
    const std::uint32_t p = g.add_crossing(left, right, m.root[0]), q = g.add_crossing(left, right, m.root[1]);
    const bool first = g.points[p].y > 0;
    upper = first ? p : q;
    lower = first ? q : p;
    on_line = g.add_grid_point(0, 4);
    real = g.add_real_point(Real::ratio(1, 3), sqrt(Real(2)));
  }
};

TEST(Excerpt, CopiesAreTheSamePoints) {
  const Whole w;
  Excerpt e(w.g);
  for (const std::uint32_t p : {w.real, w.on_line, w.lower, w.upper}) {
    const RealPoint was = w.g.exact(p), is = e.geometry().exact(e.point(p));
    EXPECT_EQ(was.x, is.x);
    EXPECT_EQ(was.y, is.y);
  }
}

TEST(Excerpt, RootsOfCirclesKeepTheirMeaningInAnyOrder) {
  const Whole w;
  Excerpt e(w.g);
  const std::uint32_t right = e.curve(w.right), left = e.curve(w.left);  // the other way round
  EXPECT_LT(right, left);
  const std::uint32_t upper = e.point(w.upper), lower = e.point(w.lower);
  EXPECT_EQ(e.geometry().exact_y(upper), Real(4));
  EXPECT_EQ(e.geometry().exact_y(lower), Real(-4));
  EXPECT_EQ(compare_xy(e.geometry(), upper, e.point(w.on_line)), 0);
}

TEST(Excerpt, NothingIsCopiedTwice) {
  const Whole w;
  Excerpt e(w.g);
  EXPECT_EQ(e.point(w.upper), e.point(w.upper));
  EXPECT_EQ(e.curve(w.line), e.curve(w.line));
  EXPECT_EQ(e.geometry().supporting_curves.size(), 3u);
  EXPECT_EQ(e.geometry().points.size(), 1u);
  e.clear();
  EXPECT_EQ(e.size(), 0u);
  EXPECT_EQ(e.geometry().points.size(), 0u);
}

}  // namespace exact_excerpt
}  // namespace findspace::exact
