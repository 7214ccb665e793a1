// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of outlines of many chords, lobes of one against lobes of the other, so that most curves of the convolution are
// covered and left out, against the arrangement of the whole convolution, cell by cell. What is said to be covered lies
// in the open sum.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "differential/whole_sum.h"
#include "plane/contour/contour.h"
#include "plane/grid/covered_curves.h"
#include "plane/grid/grid_faces.h"
#include "plane/grid/reduced_convolution.h"
#include "plane/query/locate.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace plane_covered_curves {

/// A ring with so many lobes, or that turned by 180 degrees.
Region lobes(int count, int corners, double deep, int sense) {
  std::vector<Contour> rings(1);
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * k / corners, r = 10000 * (1 + deep * std::cos(count * angle));
    rings[0].push_back(
        {.start = {sense * std::llround(r * std::cos(angle)), sense * std::llround(r * std::sin(angle))}});
  }
  return region_of_rings(make_rings(rings, 1).contours);
}

TEST(CoveredCurves, SumsOfLobes) {
  for (const int count : {12, 15}) {
    const Region a = lobes(count, 2000, 0.5, 1), b = lobes(count, 2000, 0.5, -1);
    const auto p = grid_faces(a, in, false), q = grid_faces(b, in, true);
    ASSERT_TRUE(p && q);
    const GridOperand x{*p, a.geometry}, y{*q, b.geometry};
    CoveredCurves covered(*p, *q);
    const std::size_t all = reduced_convolution(x, y).pieces.size();
    const std::size_t kept = reduced_convolution(x, y, std::nullopt, &covered).pieces.size();
    ASSERT_TRUE(covered.prepared()) << all;
    EXPECT_LT(2 * kept, all);
    expect_same(contact_map(a, b), -1, whole_sum(a, in, b), "lobes");
  }
}

TEST(CoveredCurves, BoxesLieInTheSum) {
  std::mt19937 rng(3);
  const Region a = lobes(4, 60, 0.5, 1), b = lobes(5, 60, 0.3, 1);
  const auto p = grid_faces(a, in, false), q = grid_faces(b, in, true);
  ASSERT_TRUE(p && q);
  CoveredCurves covered(*p, *q);
  const SignMap sum = contact_map(a, b);
  Locator locator(sum);
  std::uniform_real_distribution<double> place(-30000, 30000), size(0, 3000);
  int held = 0, out = 0;
  for (int k = 0; k < 20000; ++k) {
    const CoveredBox box = [&] {
      const double x0 = place(rng), y0 = place(rng);
      return CoveredBox{x0, y0, x0 + size(rng), y0 + size(rng)};
    }();
    const bool holds = covered.covers(box);
    held += holds;
    out += !holds;
    if (!holds) continue;
    for (const double x : {box.x0, box.x1})
      for (const double y : {box.y0, box.y1})
        EXPECT_LT(locator.mark({exact::Real::from_double(x), exact::Real::from_double(y)}), 0);
  }
  EXPECT_GT(held, 1000);
  EXPECT_GT(out, 1000);
}

}  // namespace plane_covered_curves
}  // namespace findspace::plane
