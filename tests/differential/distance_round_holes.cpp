// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The directed Hausdorff distance from a plate to a frame whose hole is a circle drawn as a polygon: many edges are all
// but equally far from the middle, and the value is the radius of the largest circle in the hole. Against that radius
// by nested search: the distance to the hole's edges is concave. With the hole's middle just outside the plate the
// place on the plate's edge decides, against a search along it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "../unit/distance_shapes.h"
#include "distance/planar/at_position.h"

using namespace findspace::distance;
using findspace::exact::Real;
using findspace::plane::Region;
namespace plane = findspace::plane;

namespace distance_round_holes {

constexpr std::int64_t kSize = 1000000;

struct Corner {
  double x, y;
};

std::vector<Corner> circle(std::mt19937& random, int corners) {
  std::vector<Corner> out;
  const double rotation = std::uniform_real_distribution(0.0, 1.0)(random);
  for (int k = 0; k < corners; ++k) {
    const double t = 2 * std::numbers::pi * (k + rotation) / corners;
    out.push_back({std::round(double(kSize) * std::cos(t)), std::round(double(kSize) * std::sin(t))});
  }
  return out;
}

/// To the lines of a convex polygon that runs counter-clockwise.
long double depth(const std::vector<Corner>& ring, long double x, long double y) {
  long double least = 10 * kSize;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Corner &p = ring[k], &q = ring[(k + 1) % ring.size()];
    const long double dx = q.x - p.x, dy = q.y - p.y;
    least = std::min(least, (dx * (y - p.y) - dy * (x - p.x)) / std::sqrt(dx * dx + dy * dy));
  }
  return least;
}

template <class Function>
long double greatest(long double low, long double high, Function&& f) {
  for (int k = 0; k < 90; ++k) {
    const long double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (f(a) < f(b) ? low : high) = f(a) < f(b) ? a : b;
  }
  return f(low);
}

/// Of the places with x >= least_x.
long double deepest(const std::vector<Corner>& ring, long double least_x) {
  return greatest(least_x, 1000, [&](long double x) {
    return greatest(-1000, 1000, [&](long double y) { return depth(ring, x, y); });
  });
}

TEST(RoundHoles, ThePlateReachesTheRadiusOfTheLargestCircle) {
  std::mt19937 random(5);
  for (int corners : {9, 11, 24, 60}) {
    const auto ring = circle(random, corners);
    plane::Contour hole;
    for (auto k = ring.rbegin(); k != ring.rend(); ++k)
      hole.push_back({.start = {std::int64_t(k->x), std::int64_t(k->y)}});
    const std::int64_t outer = 3 * kSize;
    const plane::Contour frame =
        findspace::testing::ring({{-outer, -outer}, {outer, -outer}, {outer, outer}, {-outer, outer}});
    const Region a = plane::region_of_rings(plane::make_rings({frame, hole}, 1).contours);
    // The plate's left edge passes left of all middles, and through them.
    for (std::int64_t left : {-2 * kSize, std::int64_t(1)}) {
      const Region plate = findspace::testing::box(left, -2 * kSize, 2 * kSize, 2 * kSize);
      const AtPosition at(std::make_shared<ShapePair>(plate, a));
      const auto m = at.measure(Which::kMu, {Real(), Real()});
      ASSERT_TRUE(m);
      const double expected = double(deepest(ring, std::max<long double>(double(left), -1000)));
      EXPECT_NEAR(m->value.to_double(), expected, expected * 1e-12) << corners << " corners, plate from " << left;
    }
  }
}

}  // namespace distance_round_holes
