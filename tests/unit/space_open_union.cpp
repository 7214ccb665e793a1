// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The complement point nearest to a place that many sets hold: against the cells of a lattice, and where all
// projections would be more than can be tried.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "plane/base/search_work.h"
#include "space/body/open_union.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_open_union {

using exact::Real;

struct Block {
  std::array<std::int64_t, 3> low, high;
};

OpenUnion::Planes planes_of(const Block& b) {
  OpenUnion::Planes planes;
  for (std::size_t k = 0; k < 3; ++k) {
    RealVector n;
    n[k] = Real(1);
    planes.emplace_back(negated(n), Real(b.low[k]));
    planes.emplace_back(n, Real(-b.high[k]));
  }
  return planes;
}

Extent extent_of(const Block& b) {
  const auto vector = [](const std::array<std::int64_t, 3>& c) {
    return Vector{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
  };
  return {vector(b.low), vector(b.high)};
}

/// The square of the distance from p to the nearest vertex, open edge, face or cell of the lattice that no block holds.
std::int64_t nearest_by_cells(const std::vector<Block>& blocks, std::int64_t p, std::int64_t size) {
  std::int64_t best = 1'000'000;
  for (std::int64_t x = -1; x <= 2 * size + 1; ++x) {  // twice the coordinates of a middle
    for (std::int64_t y = -1; y <= 2 * size + 1; ++y) {
      for (std::int64_t z = -1; z <= 2 * size + 1; ++z) {
        const std::array<std::int64_t, 3> at{x, y, z};
        std::int64_t square = 0;
        for (const std::int64_t c : at) {
          const std::int64_t off = std::max<std::int64_t>(std::abs(c - 2 * p) - std::abs(c % 2), 0) / 2;
          square += off * off;
        }
        if (square >= best) continue;
        const bool covered = std::any_of(blocks.begin(), blocks.end(), [&](const Block& b) {
          for (std::size_t k = 0; k < 3; ++k) {
            if (at[k] <= 2 * b.low[k] || at[k] >= 2 * b.high[k]) return false;
          }
          return true;
        });
        if (!covered) best = square;
      }
    }
  }
  return best;
}

/// Hundreds of blocks with few planes: corners, slits and single points where many of them meet.
TEST(OpenUnion, CrowdsOfBlocksAsTheCellsOfTheirLattice) {
  std::mt19937 random(5);
  constexpr std::int64_t kSize = 12, kMiddle = 6;
  for (int round = 0; round < 20; ++round) {
    std::uniform_int_distribution<std::int64_t> corner(0, kSize - 3), length(2, 3 + round % 5);
    std::vector<Block> blocks{{{kMiddle - 1, kMiddle - 1, kMiddle - 1}, {kMiddle + 1, kMiddle + 1, kMiddle + 1}}};
    for (int k = 0; k < 200 * (1 + round % 4); ++k) {
      Block b;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        b.low[axis] = corner(random);
        b.high[axis] = std::min(kSize, b.low[axis] + length(random));
      }
      blocks.push_back(b);
    }
    OpenUnion cover;
    for (const Block& b : blocks) cover.add(extent_of(b), planes_of(b));
    const RealVector p = place(kMiddle, kMiddle, kMiddle);
    const auto q = cover.nearest_in_complement(p).at;
    ASSERT_TRUE(q) << round;
    EXPECT_FALSE(cover.covers(*q)) << round;
    const RealVector off = minus(*q, p);
    EXPECT_EQ(dot(off, off), Real(nearest_by_cells(blocks, kMiddle, kSize))) << round;
  }
}

/// 8,000 tetrahedra whose planes are all different: p lies deep in them.
TEST(OpenUnion, CrowdsOfTetrahedra) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> corner(-60, 60), about(-45, 45);
  OpenUnion cover;
  while (cover.size() < 8000) {
    const RealVector middle = place(about(random), about(random), about(random));
    std::array<RealVector, 4> v;
    for (RealVector& c : v) c = plus(middle, place(corner(random), corner(random), corner(random)));
    OpenUnion::Planes planes;
    std::vector<Vector> near;
    for (std::size_t k = 0; k < 4; ++k) {
      near.push_back(rounded(v[k]));
      RealVector n = cross(minus(v[(k + 2) % 4], v[(k + 1) % 4]), minus(v[(k + 3) % 4], v[(k + 1) % 4]));
      if (dot(n, minus(v[k], v[(k + 1) % 4])).sign() > 0) n = negated(n);
      if (is_zero(n)) break;
      planes.emplace_back(n, -dot(n, v[(k + 1) % 4]));
    }
    if (planes.size() == 4) cover.add(space::extent_of(near), std::move(planes));
  }
  const RealVector p = place(0, 0, 0);
  ASSERT_TRUE(cover.covers(p));
  plane::SearchQuestion question;
  const auto q = cover.nearest_in_complement(p).at;
  ASSERT_TRUE(q);
  EXPECT_FALSE(cover.covers(*q));
  const Real square = dot(*q, *q);
  // A search that may look at less ends there, with a bound.
  const long all = plane::kMostCellsOfQuestion - question.work().left;
  EXPECT_GT(all, 10);
  for (const long some : {1L, all / 4, all - 1}) {
    plane::SearchWork work{some};
    const plane::ScopedSearchWork here(&work);
    const NearestOutside early = cover.nearest_in_complement(p);
    EXPECT_LE(some - work.left, some + 1000) << some;
    EXPECT_LE(Real::from_double(early.bound) * Real::from_double(early.bound), square) << some;
    EXPECT_EQ(bool(early.settled()), !early.spent);
    if (some < all / 2) EXPECT_TRUE(early.spent) << some;
  }
  EXPECT_LT(Real(20 * 20), square);
  std::uniform_int_distribution<std::int64_t> place_in(-100'000, 100'000);
  for (int k = 0; k < 20'000; ++k) {
    RealVector x{Real::ratio(place_in(random), 1000), Real::ratio(place_in(random), 1000),
                 Real::ratio(place_in(random), 1000)};
    EXPECT_TRUE(dot(x, x) >= square || cover.covers(x)) << k;
  }
}

}  // namespace space_open_union
}  // namespace findspace::space
