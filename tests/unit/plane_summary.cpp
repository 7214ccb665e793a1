// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plane/query/locate.h"
#include "plane/query/measure_cells.h"
#include "plane/query/summary.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_summary {

using exact::Real;
constexpr double kPi = std::numbers::pi;

Summary of(const Region& s) { return summarize(s, Real(1)); }

/// Every sample lies in the set, strictly inside where its component has an interior.
void expect_good_samples(const Region& s) {
  for (const Component& c : of(s).components) {
    Cell cell = locate(s, c.sample_point);
    EXPECT_EQ(cell.dimension, c.dimension);
    EXPECT_EQ(mark_of(s, cell), 1);
  }
}

TEST(Summary, Empty) {
  Summary r = of(Region::uniform(0));
  EXPECT_TRUE(r.empty && !r.whole && r.bounded && r.open && r.closed && r.regular);
  EXPECT_EQ(r.area, 0.0);
  EXPECT_TRUE(r.components.empty() && r.isolated.empty() && !r.bbox);
  EXPECT_EQ(r.holes, 0);
}

TEST(Summary, WholePlane) {
  Summary r = of(Region::uniform(1));
  EXPECT_TRUE(!r.empty && r.whole && !r.bounded && r.open && r.closed && r.regular);
  EXPECT_FALSE(r.area || r.bbox);
  ASSERT_EQ(r.components.size(), 1u);
  EXPECT_FALSE(r.components[0].area || r.components[0].bbox);
  EXPECT_EQ(r.components[0].sample, (Place{0, 0}));
}

TEST(Summary, Point) {
  Summary r = of(point(3, 4));
  EXPECT_EQ(r.isolated, (std::vector<Place>{{3, 4}}));
  ASSERT_EQ(r.components.size(), 1u);
  EXPECT_EQ(r.components[0].dimension, 0);
  EXPECT_EQ(r.components[0].sample, (Place{3, 4}));
  EXPECT_EQ(r.bbox->low, (Place{3, 4}));
  EXPECT_EQ(r.bbox->high, (Place{3, 4}));
  EXPECT_TRUE(r.closed && !r.open && !r.regular);
}

TEST(Summary, FreeSegment) {
  Summary r = of(segment({0, 0}, {3, 4}));
  EXPECT_EQ(r.dangling_length, 5);
  EXPECT_EQ(r.area, 0.0);
  ASSERT_EQ(r.components.size(), 1u);
  EXPECT_EQ(r.components[0].dimension, 1);
  EXPECT_EQ(r.components[0].sample, (Place{1.5, 2}));
  EXPECT_TRUE(r.isolated.empty());
}

TEST(Summary, Box) {
  Summary r = summarize(box(0, 0, 3000000, 1000000), Real::ratio(1, 1000000));
  EXPECT_EQ(r.area, 3.0);
  EXPECT_EQ(r.bbox->high, (Place{3, 1}));
  EXPECT_TRUE(r.closed && r.regular && !r.open);
  EXPECT_EQ(r.holes, 0);
  EXPECT_EQ(r.components[0].sample[1], 0.5);
  EXPECT_EQ(r.crack_length, 0);
}

TEST(Summary, GridStepsPrintAsWritten) {
  Summary r = summarize(box(-300000, 100000, 100000, 700000), Real::ratio(1, 1000000));
  EXPECT_EQ(r.bbox->low, (Place{-0.3, 0.1}));
  EXPECT_EQ(r.bbox->high, (Place{0.1, 0.7}));
  EXPECT_EQ(r.area, 0.24);
}

TEST(Summary, FullDisc) {
  Summary r = of(disc(10, -20, 5));
  EXPECT_DOUBLE_EQ(*r.area, 25 * kPi);
  EXPECT_EQ(r.bbox->low, (Place{5, -25}));
  EXPECT_EQ(r.bbox->high, (Place{15, -15}));
  EXPECT_TRUE(r.regular);
}

TEST(Summary, ArcWhoseTopIsNoVertex) {
  // The part of a disc above y = 3: its top is inside the arc; that below y = -3 likewise.
  Summary up = of(disc(0, 0, 5) & box(-9, 3, 9, 9)), down = of(disc(0, 0, 5) & box(-9, -9, 9, -3));
  EXPECT_EQ(up.bbox->low, (Place{-4, 3}));
  EXPECT_EQ(up.bbox->high, (Place{4, 5}));
  EXPECT_EQ(down.bbox->low, (Place{-4, -5}));
  double angle = 2 * std::asin(0.8);
  EXPECT_DOUBLE_EQ(*up.area, 12.5 * (angle - std::sin(angle)));
  // The part right of x = 3 has neither top nor bottom.
  EXPECT_EQ(of(disc(0, 0, 5) & box(3, -9, 9, 9)).bbox->high, (Place{5, 4}));
}

TEST(Summary, ThinRingKeepsItsDigits) {
  const std::int64_t r = 100000000;
  Summary s = of(disc(0, 0, Real(r + 1)) - interior(disc(0, 0, Real(r))));
  EXPECT_DOUBLE_EQ(*s.area, kPi * (2.0 * r + 1));
  EXPECT_EQ(s.holes, 1);
  expect_good_samples(disc(0, 0, Real(r + 1)) - interior(disc(0, 0, Real(r))));
}

TEST(Summary, SliverFarFromTheOrigin) {
  const std::int64_t far = 1000000000000;
  Region s = polygon({{far, far}, {far + 1000000, far + 999999}, {far + 1000001, far + 1000000}});
  EXPECT_EQ(of(s).area, 0.5);
  expect_good_samples(s);
}

TEST(Summary, RingWithAnIslandAndAPoint) {
  Region ring = box(0, 0, 30, 30) - interior(box(5, 5, 25, 25));
  Region s = ring + box(10, 10, 20, 20) + point(7, 7);
  Summary r = of(s);
  EXPECT_EQ(r.holes, 1);
  ASSERT_EQ(r.components.size(), 3u);
  EXPECT_EQ(r.components[0].holes, 1);  // the ring's; the island does not fill it up
  EXPECT_EQ(r.components[1].holes, 0);
  EXPECT_EQ(r.components[2].dimension, 0);
  EXPECT_EQ(r.area, 900.0 - 400 + 100);
  expect_good_samples(s);
}

TEST(Summary, PunctureIsAHole) {
  Summary r = of(box(0, 0, 4, 4) - point(2, 2));
  EXPECT_EQ(r.holes, 1);
  EXPECT_TRUE(!r.closed && !r.open && !r.regular);
  EXPECT_EQ(r.components[0].holes, 1);
  EXPECT_EQ(r.area, 16.0);
}

TEST(Summary, PlaneWithoutABox) {
  Region s = complement(box(0, 0, 4, 4));
  Summary r = of(s);
  EXPECT_TRUE(!r.bounded && r.open && !r.closed);
  EXPECT_FALSE(r.area || r.bbox);
  EXPECT_EQ(r.holes, 1);
  expect_good_samples(s);
}

TEST(Summary, PlaneWithoutABoxButWithItsCentre) {
  Region s = complement(box(0, 0, 4, 4)) + point(2, 2);
  Summary r = of(s);
  EXPECT_EQ(r.holes, 1);
  ASSERT_EQ(r.components.size(), 2u);
  EXPECT_FALSE(r.components[0].area);
  EXPECT_EQ(r.components[0].holes, 1);
  EXPECT_EQ(r.components[1].holes, 0);
  EXPECT_EQ(r.isolated, (std::vector<Place>{{2, 2}}));
}

TEST(Summary, CrackIsAHoleUnlessItReachesTheBoundary) {
  Summary inner = of(box(0, 0, 10, 10) - segment({2, 5}, {8, 5}));
  EXPECT_EQ(inner.crack_length, 6);
  EXPECT_EQ(inner.holes, 1);
  Summary half = of(box(0, 0, 10, 10) - segment({2, 5}, {10, 5}));
  EXPECT_EQ(half.crack_length, 8);
  EXPECT_EQ(half.holes, 0);
  Summary through = of(box(0, 0, 10, 10) - segment({0, 5}, {10, 5}));
  EXPECT_EQ(through.crack_length, 10);
  EXPECT_EQ(through.components.size(), 2u);
}

TEST(Summary, WhiskersBelongToTheirFace) {
  Region s = box(0, 0, 10, 10) + segment({10, 5}, {14, 5}) + segment({20, 0}, {20, 3});
  Summary r = of(s);
  EXPECT_EQ(r.dangling_length, 7);
  ASSERT_EQ(r.components.size(), 2u);
  EXPECT_EQ(r.components[0].dangling_length, 4);
  EXPECT_EQ(r.components[0].bbox->high, (Place{14, 10}));
  EXPECT_EQ(r.components[1].dangling_length, 3);
  EXPECT_FALSE(r.regular);
}

TEST(Summary, FacesThatTouchInAVertex) {
  Region touching = box(0, 0, 4, 4) + box(4, 4, 8, 8);
  EXPECT_EQ(of(touching).components.size(), 1u);
  EXPECT_EQ(of(interior(touching)).components.size(), 2u);
  EXPECT_EQ(of(touching - point(4, 4)).components.size(), 2u);
  // The complement of two boxes that touch is one piece around them; two that touch twice enclose a hole.
  EXPECT_EQ(of(touching).holes, 0);
  Region twice = touching + box(0, 4, 1, 8) + box(0, 7, 8, 8);
  EXPECT_EQ(of(twice).holes, 1);
  EXPECT_EQ(of(twice - point(4, 4)).holes, 0);
}

TEST(Summary, WhiskerThatClosesALoopMakesAHole) {
  Region c = box(0, 0, 9, 9) - (interior(box(3, 3, 9, 6)) + (segment({9, 3}, {9, 6}) - point(9, 3) - point(9, 6)));
  EXPECT_EQ(of(c).holes, 0);
  EXPECT_EQ(of(c + segment({9, 3}, {9, 6})).holes, 1);
  EXPECT_EQ(of((c + segment({9, 3}, {9, 6})) - point(9, 5)).holes, 0);
}

TEST(Summary, CircleAsACurve) {
  Summary r = of(boundary(disc(0, 0, 2)));
  EXPECT_DOUBLE_EQ(r.dangling_length, 4 * kPi);
  EXPECT_EQ(r.holes, 1);
  EXPECT_EQ(r.area, 0.0);
  EXPECT_EQ(r.components[0].dimension, 1);
  EXPECT_EQ(r.bbox->high, (Place{2, 2}));
}

TEST(Summary, OrderIsFromLeftToRight) {
  Summary r = of(box(10, 0, 12, 2) + box(0, 5, 1, 6) + box(0, 0, 1, 1) + point(-5, 0) + point(-6, 0));
  ASSERT_EQ(r.components.size(), 5u);
  EXPECT_EQ(r.components[0].bbox->low, (Place{0, 0}));
  EXPECT_EQ(r.components[1].bbox->low, (Place{0, 5}));
  EXPECT_EQ(r.components[2].bbox->low, (Place{10, 0}));
  EXPECT_EQ(r.isolated, (std::vector<Place>{{-6, 0}, {-5, 0}}));
}

TEST(Summary, IrrationalRadius) {
  Summary r = of(disc(0, 0, sqrt(Real(2))));
  EXPECT_DOUBLE_EQ(*r.area, 2 * kPi);
  EXPECT_DOUBLE_EQ(r.bbox->high[0], std::numbers::sqrt2);
}

TEST(Summary, FaceTooThinForDoubles) {
  // Between a circle through a far point and its chord of two steps: less than 1e-12 high.
  Region s = disc(0, -1000000000000, Real(1000000000000)) & box(-1, -1, 1, 1);
  expect_good_samples(s);
  Region lens = s - interior(polygon({{-1, -1}, {1, -1}, {0, 0}}));
  expect_good_samples(lens);
}

TEST(Twofold, AnglesToThirtyDigits) {
  // tan(pi / 8) = sqrt(2) - 1: eight such angles make pi.
  Twofold x(1), y = sqrt(Twofold(2)) - Twofold(1), pi(3.141592653589793, 1.2246467991473532e-16);
  Twofold error = atan2(y, x) * Twofold(8) - pi;
  EXPECT_LT(std::abs(error.value()), 1e-29);
  EXPECT_LT(std::abs((atan2(-y, -x) * Twofold(8) + Twofold(7) * pi).value()), 1e-28);
  Twofold small = atan2(Twofold(0x1p-60), Twofold(1));
  EXPECT_EQ(small.hi, 0x1p-60);
}

}  // namespace plane_summary
}  // namespace findspace::plane
