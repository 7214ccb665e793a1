// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <gtest/gtest.h>

#include <random>

#include "distance/search/convex_distance.h"
#include "space/body/open_union.h"
#include "space/polytope/polytope.h"

namespace findspace::distance {
namespace distance_convex_distance {

using space::HalfSpace;
using space::Vector;

double exact_distance(const std::vector<HalfSpace>& planes, const Vector& x) {
  const space::RealVector p = space::real(x), off = space::minus(*nearest_in(planes, p), p);
  return exact::sqrt(space::dot(off, off)).to_double();
}

std::vector<HalfSpace> planes_of(const std::vector<space::Point>& corners) {
  const space::Polytope hull = space::Polytope::hull(corners);
  return {hull.planes().begin(), hull.planes().end()};
}

bool flat(const std::vector<space::Point>& c) {
  return exact::sign(exact::dot(exact::cross(c[1] - c[0], c[2] - c[0]), c[3] - c[0])) == 0;
}

/// Parts of meshes are as thin as a rounding of their corners: the angle of two faces is then one in a million.
TEST(ConvexDistance, OfThinParts) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> wide(-2'000'000, 2'000'000), thin(-2, 2);
  std::uniform_real_distribution<double> place(-4e6, 4e6);
  int thin_ones = 0;
  for (int round = 0; round < 300; ++round) {
    // Four corners of nearly one plane.
    std::vector<space::Point> corners;
    for (int k = 0; k < 4; ++k) {
      const std::int64_t x = wide(random), y = wide(random);
      corners.push_back({x, y, x / 2 + y / 3 + thin(random)});
    }
    if (flat(corners)) continue;
    ++thin_ones;
    const std::vector<HalfSpace> planes = planes_of(corners);
    const ConvexDistance distance = distance_to(planes);
    for (int k = 0; k < 10; ++k) {
      const Vector x{place(random), place(random), place(random)};
      const double exact = exact_distance(planes, x);
      EXPECT_NEAR(distance(x), exact, 1e-9 * (exact + space::size_of(x))) << round << " " << k;
    }
  }
  EXPECT_GT(thin_ones, 100);
}

TEST(ConvexDistance, OfBulkyParts) {
  std::mt19937 random(8);
  std::uniform_int_distribution<std::int64_t> wide(-1000, 1000);
  std::uniform_real_distribution<double> place(-3000, 3000);
  for (int round = 0; round < 200; ++round) {
    std::vector<space::Point> corners;
    for (int k = 0; k < 8; ++k) corners.push_back({wide(random), wide(random), wide(random)});
    const std::vector<HalfSpace> planes = planes_of(corners);
    const ConvexDistance distance = distance_to(planes);
    for (int k = 0; k < 10; ++k) {
      const Vector x{place(random), place(random), place(random)};
      EXPECT_NEAR(distance(x), exact_distance(planes, x), 1e-10 * (1 + space::size_of(x))) << round << " " << k;
    }
  }
}

}  // namespace distance_convex_distance
}  // namespace findspace::distance
