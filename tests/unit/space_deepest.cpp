// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Largest balls in polyhedra: closed forms, ties, and random polytopes against random places.
#include <gtest/gtest.h>

#include "differential/space_oracle.h"
#include "space/polytope/deepest.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_deepest {

using exact::Real;

std::vector<HalfSpace> planes_of(const Polytope& p) {
  std::vector<HalfSpace> out;
  for (const Plane& h : p.planes()) out.emplace_back(h);
  return out;
}

Real highest(const std::vector<HalfSpace>& planes, const RealVector& p) {
  std::optional<Real> best;
  for (const HalfSpace& h : planes) {
    const Real v = h.value(p) / sqrt(dot(h.normal, h.normal));
    if (!best || *best < v) best = v;
  }
  return *best;
}

TEST(Deepest, ClosedForms) {
  const RealVector low = place(-20, -20, -20), high = place(20, 20, 20);
  const std::vector<Point> corners{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}};
  const auto in = deepest(planes_of(Polytope::hull(corners)), low, high);
  ASSERT_TRUE(in);
  EXPECT_EQ(in->value, Real(-6) / (Real(3) + sqrt(Real(3))));
  EXPECT_EQ(in->at[0], -in->value);
  const auto cube = deepest(planes_of(box_polytope({{{0, 0, 0}, {4, 4, 4}}})), low, high);
  ASSERT_TRUE(cube);
  EXPECT_EQ(cube->value, Real(-2));
  EXPECT_EQ(cube->at, place(2, 2, 2));
  // A brick has a segment of deepest places.
  EXPECT_FALSE(deepest(planes_of(box_polytope({{{0, 0, 0}, {4, 4, 5}}})), low, high));
  // Opposite walls that overlap by 2: nothing is inside, the middle misses them all by 1.
  std::vector<HalfSpace> none = planes_of(box_polytope({{{0, 0, 0}, {4, 4, 4}}}));
  for (HalfSpace& h : none) h = HalfSpace(h.normal, h.offset + Real(3));
  const auto missed = deepest(none, low, high);
  ASSERT_TRUE(missed);
  EXPECT_EQ(missed->value, Real(1));
}

TEST(Deepest, RandomPolytopes) {
  RandomPolytopes random(5);
  int found = 0;
  for (int round = 0; round < 40; ++round) {
    const auto [p, q] = random.pair();
    const std::vector<HalfSpace> planes = planes_of(p);
    const auto best = deepest(planes, place(-1000, -1000, -1000), place(1000, 1000, 1000));
    if (!best) continue;
    ++found;
    EXPECT_EQ(highest(planes, best->at), best->value);
    for (int k = 0; k < 20; ++k) {
      const RealVector off = place(random.pick(-9, 9), random.pick(-9, 9), random.pick(-9, 9), 64);
      EXPECT_LE(best->value, highest(planes, plus(best->at, off)));
    }
  }
  EXPECT_GT(found, 10);
}

}  // namespace space_deepest
}  // namespace findspace::space
