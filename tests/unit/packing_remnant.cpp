// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The largest rectangle that the last sheet has left: by hand, against all rectangles of a lattice, beside slanted
// edges and arcs.
#include <gtest/gtest.h>

#include <random>

#include "packing/problem/round_part.h"
#include "packing/proof/remnant.h"
#include "plane/complex/primitives.h"

namespace findspace::packing {
namespace packing_remnant {

Ring box_ring(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Problem plates(int width, int height, std::vector<Part> parts) {
  Problem problem;
  problem.sheets.push_back({"plate", 9, {}, make_polygon({box_ring(0, 0, width, height)}, "plate")});
  problem.parts = std::move(parts);
  return problem;
}

Placed at(std::size_t part, const Fraction& x, const Fraction& y, std::size_t sheet = 0) {
  return {.part = part, .copy = 1, .angle = 0, .mirrored = false, .x = x, .y = y, .sheet = sheet};
}

void expect(const std::optional<Remnant>& found, const Fraction& x, const Fraction& y, const Fraction& width,
            const Fraction& height) {
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->x, x);
  EXPECT_EQ(found->y, y);
  EXPECT_EQ(found->width, width);
  EXPECT_EQ(found->height, height);
}

TEST(Remnant, NoneOfAStripOrAFullSheet) {
  Problem problem = plates(10, 6, {{"box", 1, make_polygon({box_ring(0, 0, 10, 6)}, "box")}});
  Layout layout;
  EXPECT_FALSE(largest_remnant(problem, layout).has_value());
  layout.sheets = {0};
  layout.items = {at(0, 0, 0)};
  EXPECT_FALSE(largest_remnant(problem, layout).has_value());
}

TEST(Remnant, BesideABoxOnTheLastSheet) {
  const Problem problem = plates(10, 6, {{"box", 2, make_polygon({box_ring(0, 0, 4, 5)}, "box")}});
  Layout layout;
  layout.sheets = {0, 0};
  layout.items = {at(0, 6, 0), at(0, 0, 0, 1)};
  expect(largest_remnant(problem, layout), 4, 0, 6, 6);
  layout.items[1].x = Fraction(1, 3);
  expect(largest_remnant(problem, layout), Fraction(13, 3), 0, Fraction(17, 3), 6);
}

TEST(Remnant, KeepsTheGap) {
  Problem problem = plates(10, 6, {{"box", 1, make_polygon({box_ring(0, 0, 4, 5)}, "box")}});
  problem.gap = Fraction(1, 2);
  Layout layout;
  layout.sheets = {0};
  layout.items = {at(0, 0, 0)};
  expect(largest_remnant(problem, layout), Fraction(9, 2), 0, Fraction(11, 2), 6);
}

TEST(Remnant, HolesAndSlantedEdges) {
  Problem problem = plates(10, 10, {});
  problem.sheets[0].shape = make_polygon({{{0, 0}, {10, 0}, {0, 10}}, box_ring(1, 1, 2, 2)}, "corner");
  Layout layout;
  layout.sheets = {0};
  const auto found = largest_remnant(problem, layout);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->width.to_double() * found->height.to_double(), 16, 0.2);  // 4 x 4 beside the hole
  EXPECT_LE(found->x + found->width + found->y + found->height, Fraction(10));
}

TEST(Remnant, BesideADisc) {
  Problem problem = plates(1000000, 1000000, {});
  Part disc{"disc", 1, {}};
  disc.round = std::make_shared<const RoundPart>(plane::region_of_disc(0, 0, 300000));
  disc.shape = disc.round->at(0, false).about;
  problem.parts = {disc};
  Layout layout;
  layout.sheets = {0};
  layout.items = {at(0, 300000, 300000)};
  const auto found = largest_remnant(problem, layout);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->width.to_double() * found->height.to_double(), 1e6 * 4e5, 1e7);
}

TEST(Remnant, AgainstAllRectanglesOfALattice) {
  std::mt19937 random(3);
  constexpr int kSize = 9;
  for (int trial = 0; trial < 60; ++trial) {
    bool taken[kSize][kSize] = {};
    Problem problem = plates(kSize, kSize, {{"dot", 99, make_polygon({box_ring(0, 0, 1, 1)}, "dot")}});
    Layout layout;
    layout.sheets = {0};
    for (int k = 0; k < 8; ++k) {
      const int x = int(random() % kSize), y = int(random() % kSize);
      if (!taken[x][y]) layout.items.push_back(at(0, x, y));
      taken[x][y] = true;
    }
    int most = 0;
    for (int x = 0; x < kSize; ++x)
      for (int y = 0; y < kSize; ++y)
        for (int right = x + 1; right <= kSize; ++right)
          for (int top = y + 1; top <= kSize; ++top) {
            bool is_free = true;
            for (int i = x; i < right; ++i)
              for (int j = y; j < top; ++j) is_free &= !taken[i][j];
            if (is_free) most = std::max(most, (right - x) * (top - y));
          }
    const auto found = largest_remnant(problem, layout);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->width.to_double() * found->height.to_double(), most);
  }
}

}  // namespace packing_remnant
}  // namespace findspace::packing
