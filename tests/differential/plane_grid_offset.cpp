// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Offsets of grid polygons by walks along outer sides, against the arrangement of the whole convolution with a disc,
// cell by cell: on shapes full of ties (lattice squares with holes and slots of exactly twice the radius, combs, coarse
// lattice stars), on random stars, smooth and thin ones, on several components; from outside and from inside, with
// radii that are integers, ratios and roots. Many ties lie on the boundary, and the walks must be right there.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "differential/whole_sum.h"
#include "findspace/error.h"
#include "law/plane_invariants.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/offset/grid_offset.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace plane_grid_offset {

using exact::Real;

std::optional<Region> simple_ring(const std::vector<GridPoint>& points) {
  Contour c;
  for (auto& p : points) c.push_back({.start = p});
  try {
    return region_of_rings(make_rings({c}, 1).contours);
  } catch (const Error&) {
    return std::nullopt;  // it touches itself
  }
}

struct Count {
  int walked = 0, declined = 0;
};

void compare(const Region& set, const Real& radius, const std::string& what, Count& count) {
  for (const bool inwards : {false, true}) {
    const Region shape = inwards ? closure(complement(set)) : set;
    const auto found = grid_offset(
        shape, [](Mark m) { return m > 0; }, radius);
    ++(found ? count.walked : count.declined);
    if (!found) continue;
    ASSERT_EQ(fault(*found), "") << what;
    const SignMap expected = contact_map(shape, region_of_disc(0, 0, radius));
    std::array<const CellComplex*, 2> both{&*found, &expected};
    const Region difference = overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
    ASSERT_TRUE(difference.faces.size() == 1 && difference.faces[0].mark == 0 && difference.edges.empty() &&
                difference.vertices.empty())
        << what << (inwards ? ", in" : ", out");
    EXPECT_EQ(found->vertices.size(), expected.vertices.size()) << what;
    EXPECT_EQ(found->edges.size(), expected.edges.size()) << what;
    EXPECT_EQ(found->faces.size(), expected.faces.size()) << what;
  }
}

/// Half steps, thirds and roots among small multiples of a side.
Real radius_of(std::mt19937& rng, std::int64_t side) {
  const std::int64_t k = 1 + std::int64_t(rng() % 7);
  switch (rng() % 4) {
    case 0:
      return Real(k * side);
    case 1:
      return Real::ratio(k * side, 2);
    case 2:
      return Real::ratio(k * side, 3);
    default:
      return sqrt(Real(k)) * Real(side) / Real(2);
  }
}

TEST(GridOffset, SquaresWithSlotsAndHoles) {
  Count count;
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 rng(seed);
    const std::int64_t side = seed % 2 ? 4 : 1000;
    std::vector<Region> parts;
    for (int k = 3 + int(rng() % 14); k > 0; --k) {
      const std::int64_t x = side * std::int64_t(rng() % 5), y = side * std::int64_t(rng() % 5);
      parts.push_back(*simple_ring({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}));
    }
    compare(united(parts), radius_of(rng, side), "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(count.walked, 300);
  EXPECT_EQ(count.declined, 0);
}

TEST(GridOffset, CombsWithExactSlots) {
  Count count;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    const std::int64_t slot = 2 * (5 + std::int64_t(rng() % 20)), tooth = 5 + std::int64_t(rng() % 40);
    std::vector<GridPoint> p{{0, -20}};
    const int teeth = 2 + int(rng() % 5);
    const std::int64_t right = teeth * tooth + (teeth - 1) * slot;
    p.push_back({right, -20});
    for (int k = teeth; k-- > 0;) {
      const std::int64_t x = k * (tooth + slot), top = 10 + std::int64_t(rng() % 50);
      p.push_back({x + tooth, k + 1 == teeth ? top : 0});
      if (k + 1 < teeth) p.push_back({x + tooth, top});
      p.push_back({x, top});
      if (k > 0) p.push_back({x, 0});
    }
    auto comb = simple_ring(p);
    ASSERT_TRUE(comb) << seed;
    const std::int64_t twice[] = {slot, slot + 1, slot - 1, tooth, 2 * tooth, slot / 2};
    compare(*comb, Real::ratio(twice[rng() % 6], 2), "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(count.walked, 200);
  EXPECT_EQ(count.declined, 0);
}

TEST(GridOffset, LatticeStars) {
  Count count;
  for (unsigned seed = 0; seed < 1200; ++seed) {
    std::mt19937 rng(seed);
    const int n = 4 + int(rng() % 9);
    std::vector<GridPoint> points;
    for (int k = 0; k < n; ++k) {
      const double r = double(2 + rng() % 5), angle = 6.283185307179586 * k / n;
      points.push_back({4 * std::llround(r * std::cos(angle)), 4 * std::llround(r * std::sin(angle))});
    }
    auto star = simple_ring(points);
    if (!star) continue;
    compare(*star, radius_of(rng, 4), "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(count.walked, 600);
  EXPECT_EQ(count.declined, 0);
}

TEST(GridOffset, StarsAndSmoothShapes) {
  Count count;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    const int n = 5 + int(rng() % 60);
    const double inner = seed % 3 == 0 ? 1 : 0.3 + 0.1 * double(rng() % 7), phase = double(rng() % 100);
    std::vector<GridPoint> points;
    for (int k = 0; k < n; ++k) {
      const double angle = 6.283185307179586 * k / n;
      double r = 1e6 * (seed % 3 == 0 ? 0.7 + 0.3 * std::cos(3 * angle + phase) : k % 2 ? inner : 1);
      r *= 0.9 + 0.001 * double(rng() % 100);
      points.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
    }
    auto star = simple_ring(points);
    ASSERT_TRUE(star) << seed;
    compare(*star, Real(std::int64_t(1000) << rng() % 9), "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(count.declined, 0);
}

/// Long stretches of curves that go on in one quadrant, and those that meet.
TEST(GridOffset, SmoothShapesOfManyCorners) {
  Count count;
  for (int seed = 0; seed < 6; ++seed) {
    std::vector<GridPoint> points;
    for (int k = 0; k < 300; ++k) {
      const double angle = 6.283185307179586 * k / 300;
      const double r = 1e6 * (0.7 + 0.2 * std::cos(3 * angle + seed) + 0.03 * std::cos(11 * angle)) + k * 7919 % 100;
      points.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
    }
    compare(*simple_ring(points), Real(20000 + 60000 * seed), "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(count.declined, 0);
}

/// Frames in frames with stars in the gaps: components inside holes.
TEST(GridOffset, Nested) {
  Count count;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 rng(seed);
    auto around = [&](int n, double size, double x, double y) {
      std::vector<GridPoint> points;
      const double phase = double(rng() % 100);
      for (int k = 0; k < n; ++k) {
        const double angle = 6.283185307179586 * k / n + phase, r = size * (1 - 0.001 * double(rng() % 50));
        points.push_back({std::llround(x + r * std::cos(angle)), std::llround(y + r * std::sin(angle))});
      }
      return *simple_ring(points);
    };
    std::vector<Region> parts;
    for (int k = 1; k <= 3; ++k) {
      const double size = 50000.0 * std::exp2(k);
      std::array<Region, 2> frame{around(8 + int(rng() % 5), size, 0, 0), around(8, size * 0.8, 0, 0)};
      std::array<const Region*, 2> both{&frame[0], &frame[1]};
      parts.push_back(closure(subtract(both)));
    }
    for (int k = int(rng() % 12); k > 0; --k) {
      const double r = 60000 * std::exp2(double(k % 3 + 1)), angle = 0.523598775598299 * k;
      parts.push_back(around(3, 8000, r * std::cos(angle), r * std::sin(angle)));
    }
    compare(united(parts), Real(std::int64_t(500) << rng() % 7), "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(count.declined, 0);
}

TEST(GridOffset, Triangles) {
  Count count;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    const std::int64_t size = seed % 2 ? 60 : 1000;
    std::vector<Region> parts;
    for (int k = seed % 4 == 0 ? 3 : 1; k > 0;) {
      GridPoint p[3];
      for (auto& v : p) v = {std::int64_t(rng() % 9) * size, std::int64_t(rng() % 9) * size};
      auto triangle = simple_ring({p[0], p[1], p[2]});
      if (triangle) {
        parts.push_back(*triangle);
        --k;
      }
    }
    compare(united(parts), radius_of(rng, size), "seed " + std::to_string(seed), count);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(count.walked, 300);
}

}  // namespace plane_grid_offset
}  // namespace findspace::plane
