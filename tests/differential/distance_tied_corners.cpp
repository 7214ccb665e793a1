// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// mu(B + p, A) where two corners of B are nearly equally far from A, by less than doubles tell: against the exact
// distances of all corners of B to A's corner, which is nearest to them all.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>

#include "distance/planar/shape_pair.h"
#include "unit/distance_shapes.h"

namespace findspace::distance {
namespace distance_tied_corners {

using namespace findspace::testing;
using exact::Real;
using exact::RealPoint;

/// A corner whose cone of nearest places holds both farthest corners of B.
struct Corners {
  plane::Region a;
  RealPoint corner;
};

TEST(TiedCorners, TheFartherOneCounts) {
  const plane::Region b = polygon({{0, 0}, {2, 1}, {1, 2}});
  const std::array<RealPoint, 2> farthest{at(2, 1), at(1, 2)};
  const std::array<Corners, 3> shapes{Corners{polygon({{27, 30}, {28, 47}, {-28, -14}}), at(28, 47)},
                                      Corners{polygon({{41, -111}, {1, 9}, {-59, 29}}), at(1, 9)},
                                      Corners{polygon({{0, 0}, {-1000, 0}, {-999, -999}, {0, -1000}}), at(0, 0)}};
  std::mt19937 random(11);
  std::uniform_int_distribution<int> step(-9, 9);

  for (const Corners& shape : shapes) {
    const ShapePair pair(b, shape.a);
    for (std::int64_t unit = 10'000'000; unit <= 1'000'000'000'000'000; unit *= 10)
      for (int k = 0; k < 40; ++k) {
        const RealPoint by{Real::ratio(step(random), unit), Real::ratio(step(random), unit)};
        Real most;
        for (const RealPoint& v : farthest) {
          const Real x = v.x + by.x, y = v.y + by.y, d = sqrt(x * x + y * y);
          if (d > most) most = d;
        }
        const auto mu = pair.distance(Which::kMu)->value({shape.corner.x + by.x, shape.corner.y + by.y});
        ASSERT_TRUE(mu);
        EXPECT_EQ(mu->value, most) << mu->value.text() << " for " << most.text() << ", steps of 1/" << unit;
      }
  }
}

}  // namespace distance_tied_corners
}  // namespace findspace::distance
