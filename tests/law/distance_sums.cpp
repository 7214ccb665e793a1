// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of distances: signs between bounds hold the exact sign at random positions, leave little open, and are exact
// where the bisector is a line or a circle; the least sum encloses what a lattice of positions finds.
#include <gtest/gtest.h>

#include <cmath>

#include "distance/planar_least/distance_sum.h"
#include "distance/planar_least/sum_map.h"
#include "distance_random.h"
#include "plane/complex/overlay.h"
#include "plane/query/locate.h"
#include "plane/query/scaled.h"
#include "plane/query/summary.h"
#include "plane/query/topology.h"

namespace findspace::distance {
namespace distance_sums {

constexpr std::int64_t kFine = 1000;
constexpr double kWindow = 12 * kFine, kWidth = 40;

struct Example {
  ShapePair first, second;
  DistanceSum sum;

  Example(const Region& b, const Region& a, const Region& c, int weight)
      : first(b, a),
        second(b, c),
        sum({{first.distance(Which::kGamma1), Real(1)}, {second.distance(Which::kGamma1), Real(weight)}}) {}
};

Region fine(Region shape) { return plane::scaled(std::move(shape), kFine); }

TEST(DistanceSums, SignsHoldTheExactOnes) {
  int open = 0, asked = 0, both = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Shapes shapes(seed);
    const int weight = seed % 3 == 0 ? 2 : -1;
    const Example e(fine(shapes.rectangle()), fine(shapes.shape()), fine(shapes.shape()), weight);
    const Real level(seed % 3 == 0 ? shapes.number(2, 20) * kFine : shapes.number(-1, 1) * kFine);
    const SumSigns signs = sum_map(e.sum, level, {-kWindow, -kWindow, kWindow, kWindow}, kWidth);
    for (int k = 0; k < 60; ++k) {
      const RealPoint p{Real(shapes.number(-11999, 11999)), Real(shapes.number(-11999, 11999))};
      const auto sign = e.sum.sign(p, level);
      ASSERT_TRUE(sign);
      const int low = mark_of(signs.low, locate(signs.low, p)), high = mark_of(signs.high, locate(signs.high, p));
      EXPECT_LE(low, *sign) << "seed " << seed;
      EXPECT_GE(high, *sign) << "seed " << seed;
      ++asked;
      open += low != high;
      both += *sign < 0;
    }
  }
  EXPECT_LT(open, asked / 50);
  EXPECT_GT(both, asked / 20);
  EXPECT_LT(both, asked - asked / 20);
}

TEST(DistanceSums, BisectorsOfDiscsAreExact) {
  const auto disc = [](std::int64_t x, std::int64_t y, std::int64_t r) {
    return plane::region_of_disc(Real(x * kFine), Real(y * kFine), Real(r * kFine));
  };
  const plane::PieceBox window{-kWindow, -kWindow, kWindow, kWindow};
  const Region point = plane::region_of_disc(Real(), Real(), Real(kFine));
  // Equal radii: the line x = 1 halves nothing evenly but is exact. 3 times as far: Apollonius' circle.
  const Example line(point, disc(-3, 0, 2), disc(5, 0, 2), -1);
  const SumSigns of_line = sum_map(line.sum, Real(), window, kWidth);
  const Region left = plane::remark(of_line.low, [](plane::Mark m) { return plane::Mark(m < 0); });
  EXPECT_TRUE(plane::has_mark(of_line.low, 0));
  const auto area = [](const Region& r) { return *plane::summarize(r, Real::ratio(1, kFine)).area; };
  const Region right = plane::remark(of_line.high, [](plane::Mark m) { return plane::Mark(m > 0); });
  // Beyond the window the low sign is -1 and the high one +1: the window itself is what can be measured.
  const Region box = testing::polygon({{-12000, -12000}, {12000, -12000}, {12000, 12000}, {-12000, 12000}});
  const auto inside = [&](const Region& r) { return area(plane::intersect(std::array<const Region*, 2>{&r, &box})); };
  EXPECT_NEAR(inside(left), 13 * 24, 1e-9);
  EXPECT_NEAR(inside(right), 11 * 24, 1e-9);
}

TEST(DistanceSums, LeastOnesEncloseALattice) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Shapes shapes(seed);
    const Example e{fine(shapes.rectangle()), fine(shapes.shape()), fine(shapes.shape()), 2};  // drawn in this order
    const Region s = testing::polygon({{-9000, -8000}, {7000, -9000}, {8000, 9000}, {-2000, 7000}});
    const Extremum best = best_position(e.sum, {s, s}, Sense::kMinimum, 40.0 * kFine);
    ASSERT_TRUE(best.exists());
    const double level = near_value(best.answer->value);
    EXPECT_LE(best.bound()->to_double(), level);
    EXPECT_LT(level - best.bound()->to_double(), 16)
        << "seed " << seed;  // grid steps, of shapes of 18,000: the boxes are used up
    double lattice = exact::kInfinity;
    for (int x = -9000; x <= 8000; x += 500)
      for (int y = -9000; y <= 9000; y += 500) {
        const RealPoint p{Real(x), Real(y)};
        if (mark_of(s, locate(s, p)) > 0) lattice = std::min(lattice, near_value(*e.sum.value(p)));
      }
    EXPECT_LE(best.bound()->to_double(), lattice) << "seed " << seed;
    EXPECT_LE(level, lattice + 2) << "seed " << seed;
    // Some place that is given has the value.
    double found = exact::kInfinity;
    for (const auto& v : best.at.vertices)
      found = std::min(found, near_value(*e.sum.value(best.at.geometry.exact(v.point))));
    EXPECT_NEAR(found, level, 1e-3) << "seed " << seed;
  }
}

}  // namespace distance_sums
}  // namespace findspace::distance
