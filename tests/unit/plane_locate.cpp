// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <random>

#include "plane/query/locate.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_locate {

using exact::Real;

exact::RealPoint at(std::int64_t x, std::int64_t y) { return {Real(x), Real(y)}; }
exact::RealPoint halves(std::int64_t x, std::int64_t y) { return {Real::ratio(x, 2), Real::ratio(y, 2)}; }

int dimension_at(const Region& s, const exact::RealPoint& p) { return locate(s, p).dimension; }
int mark_at(const Region& s, const exact::RealPoint& p) { return mark_of(s, locate(s, p)); }

TEST(Locate, PlaneWithoutEdges) { EXPECT_EQ(locate(Region::uniform(1), at(3, 4)), (Cell{2, 0})); }

TEST(Locate, IsolatedPoint) {
  Region s = point(3, 4);
  EXPECT_EQ(dimension_at(s, at(3, 4)), 0);
  EXPECT_EQ(locate(s, at(3, 5)), (Cell{2, 0}));
  EXPECT_EQ(locate(s, at(3, 3)), (Cell{2, 0}));
}

TEST(Locate, BoxAndItsVerticalEdges) {
  Region s = box(0, 0, 4, 4);
  EXPECT_EQ(dimension_at(s, at(0, 0)), 0);
  EXPECT_EQ(dimension_at(s, at(0, 4)), 0);
  EXPECT_EQ(dimension_at(s, at(0, 2)), 1);
  EXPECT_EQ(dimension_at(s, at(4, 2)), 1);
  EXPECT_EQ(dimension_at(s, at(2, 0)), 1);
  EXPECT_EQ(mark_at(s, at(2, 2)), 1);
  for (auto p : {at(0, 5), at(0, -1), at(4, 5), at(4, -1), at(-1, 2), at(5, 0), at(5, 4)})
    EXPECT_EQ(locate(s, p), (Cell{2, 0}));
}

TEST(Locate, DiscBelowOnAndAboveItsHalves) {
  Region s = disc(0, 0, 5);
  EXPECT_EQ(dimension_at(s, at(5, 0)), 0);
  EXPECT_EQ(dimension_at(s, at(3, 4)), 1);
  EXPECT_EQ(dimension_at(s, at(0, -5)), 1);
  EXPECT_EQ(mark_at(s, at(4, 2)), 1);
  EXPECT_EQ(mark_at(s, at(-4, 4)), 0);
  EXPECT_EQ(mark_at(s, at(5, 1)), 0);
  EXPECT_EQ(mark_at(s, at(-5, -1)), 0);
}

TEST(Locate, IrrationalPointOnACircle) {
  Region s = disc(0, 0, 5);
  Real x = sqrt(Real(2)), y = sqrt(Real(23));
  EXPECT_EQ(dimension_at(s, {x, y}), 1);
  EXPECT_EQ(dimension_at(s, {x, -y}), 1);
  EXPECT_EQ(mark_at(s, {x, y + Real::ratio(1, exact::int128(1) << 100)}), 0);
  EXPECT_EQ(mark_at(s, {x, y - Real::ratio(1, exact::int128(1) << 100)}), 1);
}

TEST(Locate, TangentCurvesFromOneVertex) {
  // Discs that touch at their leftmost point, and a box whose top is tangent to one: decided by curvature.
  Region s = (disc(5, 0, 5) - interior(disc(3, 0, 3))) + segment({0, 20}, {10, 20});
  EXPECT_EQ(mark_at(s, at(8, 0)), 1);
  EXPECT_EQ(mark_at(s, at(3, 0)), 0);
  EXPECT_EQ(mark_at(s, {Real(0), Real(-1)}), 0);
  EXPECT_EQ(mark_at(s, {Real::ratio(1, 1000), Real(0)}), 0);
  EXPECT_EQ(mark_at(s, {Real::ratio(1, 1000), Real::ratio(9, 100)}), 1);
}

TEST(Locate, LocatorIsReusable) {
  Region s = box(0, 0, 4, 4);
  Locator locator(s);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(locator.mark(halves(1, 1)), 1);
    EXPECT_EQ(locator.mark(halves(9, 9)), 0);
    EXPECT_EQ(locator.locate(at(0, 0)).dimension, 0);
  }
}

struct TestDisc {
  std::int64_t x, y, r;
};
struct TestBox {
  std::int64_t x0, y0, x1, y1;
};

TEST(Locate, AgreesWithSetsGivenByInequalities) {
  std::mt19937 random(7);
  auto upto = [&](int n) { return std::int64_t(random() % unsigned(n)); };
  for (int round = 0; round < 40; ++round) {
    std::vector<TestDisc> discs;
    std::vector<TestBox> boxes;
    Region all = Region::uniform(0);
    for (int i = 0; i < 3; ++i) {
      discs.push_back({upto(20), upto(20), 1 + upto(6)});
      all = all + disc(discs[i].x, discs[i].y, Real(discs[i].r));
      std::int64_t x = upto(20), y = upto(20);
      boxes.push_back({x, y, x + 1 + upto(8), y + 1 + upto(8)});
      all = all + box(x, y, boxes[i].x1, boxes[i].y1);
    }
    Region open = interior(all);
    Locator in_all(all), in_open(open);
    for (int k = 0; k < 100; ++k) {
      std::int64_t x = upto(60) - 4, y = upto(60) - 4;  // in halves
      bool closed = false, inner = false;
      for (const TestDisc& d : discs) {
        std::int64_t gap = (x - 2 * d.x) * (x - 2 * d.x) + (y - 2 * d.y) * (y - 2 * d.y) - 4 * d.r * d.r;
        closed |= gap <= 0;
        inner |= gap < 0;
      }
      for (const TestBox& b : boxes) {
        closed |= x >= 2 * b.x0 && x <= 2 * b.x1 && y >= 2 * b.y0 && y <= 2 * b.y1;
        inner |= x > 2 * b.x0 && x < 2 * b.x1 && y > 2 * b.y0 && y < 2 * b.y1;
      }
      EXPECT_EQ(in_all.mark(halves(x, y)), closed);
      if (inner || !closed) {
        EXPECT_EQ(in_open.mark(halves(x, y)), inner);
      }
    }
  }
}

}  // namespace plane_locate
}  // namespace findspace::plane
