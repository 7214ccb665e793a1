// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Parts that may be tilted: what is allowed, how short layouts become, and that contacts, walls, gaps and fixed parts
// hold at any angle.
#include <gtest/gtest.h>

#include "packing/problem/round_part.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/remnant.h"
#include "packing/search/make_room.h"
#include "packing_found.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"

namespace findspace::packing {
namespace packing_tilt {

constexpr std::int64_t kUnit = 1000000;

Ring ring_of(std::vector<std::pair<int, int>> corners) {
  Ring ring;
  for (const auto& [x, y] : corners) ring.push_back({x * kUnit, y * kUnit});
  return ring;
}

Polygon box(int w, int h) { return make_polygon({ring_of({{0, 0}, {w, 0}, {w, h}, {0, h}})}, "box"); }

Problem strip(int height, std::vector<Part> parts) {
  Problem problem;
  problem.digits = 6;
  problem.height = height;
  problem.parts = std::move(parts);
  return problem;
}

Part tilting(Part part, const Fraction& tilt) {
  part.tilt = tilt;
  return part;
}

TEST(Tilt, OfOnePart) {
  Problem problem = strip(20, {tilting({"bar", 1, box(12, 4), {10}}, 10)});
  EXPECT_EQ(found(problem, 1).length, Fraction(12));  // at angle 0
  EXPECT_LE(lower_bound(problem), Fraction(12));
  problem.parts[0].tilt = 5;
  const Layout half = found(problem, 1);
  EXPECT_EQ(half.items.at(0).angle, Fraction(5));
  EXPECT_NEAR(half.length.to_double(), 12 * 0.99619469809 + 4 * 0.08715574275, 1e-6);
  problem.parts[0].tilt = 0;
  EXPECT_EQ(found(problem, 1).items.at(0).angle, Fraction(10));
}

TEST(Tilt, IsAllowedWithinItsDegrees) {
  Part part = tilting({"bar", 1, box(12, 4), {0, 90}}, Fraction(5, 2));
  for (const Fraction& angle :
       {Fraction(0), Fraction(5, 2), Fraction(-5, 2), Fraction(715, 2), Fraction(88), Fraction(450)})
    EXPECT_TRUE(part.allows(angle, false)) << angle.text();
  for (const Fraction& angle : {Fraction(26, 10), Fraction(-3), Fraction(180), Fraction(93)})
    EXPECT_FALSE(part.allows(angle, false)) << angle.text();
  EXPECT_FALSE(part.allows(0, true));
}

/// Bars on each other, at 30 degrees in the beginning: all of them lie down.
TEST(Tilt, OfPartsInContact) {
  const Problem problem = strip(60, {tilting({"bar", 3, box(20, 4), {30}}, 30)});
  EXPECT_LT(found(problem, 1).length, Fraction(205, 10));
  Problem with_gap = problem;
  with_gap.gap = 2;
  with_gap.edge = 1;
  EXPECT_LT(found(with_gap, 1).length, Fraction(225, 10));
}

TEST(Tilt, BesideAFixedPart) {
  Problem problem = strip(24, {tilting({"bar", 1, box(20, 4), {10}}, 10), {"post", 1, box(2, 20), {0}}});
  problem.fixed = {{{.part = 1, .copy = 1, .angle = 0, .mirrored = false, .x = 0, .y = 0}, 0}};
  const Layout layout = found(problem, 1);
  EXPECT_EQ(layout.items.size(), 2u);
  EXPECT_EQ(layout.length, Fraction(20));  // above the post
}

TEST(Tilt, OnASheet) {
  Problem problem = strip(0, {tilting({"bar", 2, box(20, 4), {10}}, 10)});
  problem.sheets.push_back({"plate", 2, {}, box(24, 20)});
  const Layout layout = found(problem, 1);
  EXPECT_EQ(layout.sheets.size(), 1u);
  const Remnant left = largest_remnant(problem, layout).value();  // the bars lie along the sheet
  EXPECT_GT(left.width.to_double() * left.height.to_double(), 0.95 * 24 * 12);
}

/// A part that is put elsewhere by hand stands as it stood, and so do the others.
TEST(Tilt, StaysWhereAPartIsMovedByHand) {
  const Problem problem = strip(10, {tilting({"bar", 2, box(6, 2), {0, 90}}, 5)});
  const Layout layout{30, {{0, 1, 92, false, 10, 1}, {0, 2, 88, false, 20, 1}}, {}};
  ASSERT_TRUE(verify(problem, layout).feasible());
  const auto moved = with_room(problem, layout, 0, {11, 1});
  ASSERT_TRUE(moved.has_value());
  EXPECT_TRUE(verify(problem, *moved).feasible());
  EXPECT_EQ(moved->items.at(0).angle, Fraction(92));
  EXPECT_EQ(moved->items.at(1).angle, Fraction(88));
}

TEST(Tilt, OfAPartWithAnArc) {
  const std::int64_t r = 10 * kUnit;
  const std::vector<plane::Contour> rings{
      {{.start = {0, 0}}, plane::center_arc({r, 0}, {0, r}, {0, 0}, true), {.start = {0, r}}}};
  Part part{"quarter", 2, {}, {20}};
  part.round = std::make_shared<const RoundPart>(plane::region_of_rings(rings));
  part.shape = part.round->at(0, false).about;
  const Layout layout = found(strip(30, {tilting(part, 20)}), 1);
  EXPECT_LT(layout.length, Fraction(1002, 100));  // at angle 0
}

}  // namespace packing_tilt
}  // namespace findspace::packing
