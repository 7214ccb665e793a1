// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Coarse boxes of boxes that meet, and of boxes that lie below each other, do so as well; and boxes that are well apart
// are told apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "plane/walk/coarse_box.h"

namespace findspace::plane {
namespace plane_coarse_box {

constexpr double kSize = 1000;

PieceBox random_box(std::mt19937& rng, bool whole) {
  std::uniform_real_distribution<double> place(0, kSize), length(0, kSize / 8);
  const auto number = [&](double v) { return whole ? std::floor(v / 50) * 50 : v; };
  const double x = number(place(rng)), y = number(place(rng));
  return {x, y, std::min(kSize, x + number(length(rng))), std::min(kSize, y + number(length(rng)))};
}

TEST(PlaneCoarseBox, MeetsWhatItsBoxMeets) {
  std::mt19937 rng(1);
  const CoarseGrid grid({0, 0, kSize, kSize});
  int meet = 0;
  for (int k = 0; k < 40000; ++k) {
    const PieceBox a = random_box(rng, k % 2 == 0), b = random_box(rng, k % 2 == 0);
    const CoarseBox p = grid.box(a), q = grid.box(b);
    meet += a.meets(b);
    const double gap = std::max({b.x0 - a.x1, a.x0 - b.x1, b.y0 - a.y1, a.y0 - b.y1});
    const double least = 0.001;
    const bool beside = a.x0 > b.x1 + least || b.x0 > a.x1 + least;
    if (gap <= 0) {
      EXPECT_TRUE(p.meets(q) && q.meets(p));
    } else if (gap > least) {
      EXPECT_FALSE(p.meets(q) || q.meets(p));
    }
    if (a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1) {
      EXPECT_TRUE(p.meets_strip_below(q));
    } else if (beside || a.y0 > b.y1 + least) {
      EXPECT_FALSE(p.meets_strip_below(q));
    }
    if (a.y1 >= b.y0) {
      EXPECT_FALSE(p.is_below(q));
    } else if (a.y1 < b.y0 - least) {
      EXPECT_TRUE(p.is_below(q));
    }
  }
  EXPECT_GT(meet, 100);
}

TEST(PlaneCoarseBox, OfOneOutsideIsNearest) {
  const CoarseGrid grid({-3, 2, 5, 4});
  EXPECT_TRUE(grid.nearest_box({-9, 3, -8, 3}).meets(grid.box({-3, 2, -3, 4})));
  EXPECT_FALSE(grid.nearest_box({-9, 3, -8, 3}).meets(grid.box({-2, 2, 5, 4})));
  EXPECT_TRUE(grid.nearest_box({9, 9, 10, 10}).meets(grid.box({5, 4, 5, 4})));
}

}  // namespace plane_coarse_box
}  // namespace findspace::plane
