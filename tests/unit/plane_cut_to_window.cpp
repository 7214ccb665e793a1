// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A large set cut to a window: there it is the same set, and it has far fewer edges.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "plane/build/cut_to_window.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_cut_to_window {

using Corners = std::vector<GridPoint>;

/// Waves around a circle, with small teeth.
Corners waves(int count, double radius, double height, int waves) {
  Corners out;
  for (int k = 0; k < count; ++k) {
    const double a = 2 * std::acos(-1.0) * k / count, r = radius + height * std::sin(waves * a) + 3 * (2 * k % 13);
    out.push_back({std::llround(r * std::cos(a)), std::llround(r * std::sin(a))});
  }
  return out;
}

/// Teeth upwards from a bar, 10 wide and 10 apart.
Corners comb(int teeth, int height) {
  Corners out{{0, 0}, {20 * teeth, 0}};
  for (int k = teeth; k > 0; --k)
    for (const GridPoint& p : {GridPoint{20 * k, height + k}, GridPoint{20 * k - 10, height + k},
                               GridPoint{20 * k - 10, 10}, GridPoint{20 * k - 20, 10}})
      out.push_back(p);
  return out;
}

Region window(double x0, double y0, double x1, double y1) {
  return box(std::llround(x0), std::llround(y0), std::llround(x1), std::llround(y1));
}

/// In the window the same set, with few edges; `most` of them.
void expect_cut(const Region& a, const PieceBox& w, std::size_t most) {
  const auto cut = cut_to_window(a, w);
  ASSERT_TRUE(cut);
  EXPECT_LE(cut->edges.size(), most);
  EXPECT_TRUE(is_bounded(*cut));
  const Region there = window(w.x0, w.y0, w.x1, w.y1);
  EXPECT_TRUE(same_set(*cut & there, a & there));
}

TEST(CutToWindow, Waves) {
  const Region a = polygon(waves(5000, 100000, 10000, 50));
  expect_cut(a, {86000, -4000, 94000, 4000}, 300);
  expect_cut(a, {-120000, -9000, -80000, 9000}, 500);
  expect_cut(a, {-10, -10, 10, 10}, 20);  // inside
}

TEST(CutToWindow, NothingIsLeftWhereTheWindowIsApart) {
  const Region a = polygon(waves(5000, 100000, 10000, 50));
  expect_cut(a, {200000, 0, 200100, 100}, 0);
}

TEST(CutToWindow, Holes) {
  const Region a = closure(polygon(waves(4000, 100000, 10000, 50)) - polygon(waves(4000, 50000, 10000, 20)));
  expect_cut(a, {-20, -20, 20, 20}, 20);  // in the hole
  expect_cut(a, {70000, 0, 70020, 20}, 20);
  expect_cut(a, {-1000, 35000, 1000, 65000}, 300);
  expect_cut(a, {0, 0, 120000, 3000}, 300);
}

TEST(CutToWindow, TeethFromEndToEnd) {
  const Region a = polygon(comb(400, 500));
  expect_cut(a, {1000, 100, 1100, 200}, 60);
  expect_cut(a, {1003, -20, 1107, 800}, 60);
  expect_cut(a, {1000, 507, 1400, 540}, 150);
  expect_cut(a, {1011, 100, 1019, 110}, 20);  // in a gap
}

TEST(CutToWindow, CornersThatTouch) {
  Region a = polygon(comb(300, 100));
  for (int k = 0; k < 300; ++k) a = a + box(20 * k, 100 + k + 1, 20 * k + 10, 130 + k);
  expect_cut(a, {2995, 200, 3105, 300}, 80);
}

TEST(CutToWindow, WhatIsNotCut) {
  EXPECT_FALSE(cut_to_window(box(0, 0, 10, 10), {1, 1, 2, 2}));
  const Region a = polygon(waves(5000, 100000, 10000, 50));
  EXPECT_FALSE(cut_to_window(a, {-200000, -200000, 200000, 200000}));
  EXPECT_FALSE(cut_to_window(complement(a), {0, 0, 10, 10}));
  EXPECT_FALSE(cut_to_window(interior(a), {0, 0, 10, 10}));
  EXPECT_FALSE(cut_to_window(a - box(-5, -5, 5, 5), {0, 0, 10, 10}));
  EXPECT_FALSE(cut_to_window(a + segment({0, 200000}, {10, 200000}), {0, 0, 10, 10}));
  EXPECT_FALSE(cut_to_window(a + disc(0, 200000, exact::Real(10)), {0, 0, 10, 10}));
}

}  // namespace plane_cut_to_window
}  // namespace findspace::plane
