// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Round shapes that fit only where they have zero clearance: places of sets without volume, at positions of any
// coordinates, against formulas for these sets. Where numbers cannot tell a fit from none the distance is right, or
// at least as much as is said.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "distance/rays/ray_signs.h"
#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_zero_clearance {

using exact::Real;
using space::Body;
using space::Point;

Body ball(std::int64_t radius) {
  Body b;
  b.parts.push_back({std::nullopt, {0, 0, 0}, Real(radius)});
  return b;
}

double to_segment(double x, double y, double from, double to) { return std::hypot(x - std::clamp(x, from, to), y); }

/// Of (x, y) to where a disc of radius 1 fits into the L of arms 2 wide and 6 long: two segments and what
/// lies between them and the arc about the reflex corner.
double to_places_in_l(double x, double y) {
  const double off = std::hypot(x - 2, y - 2);
  const bool seen = x <= 2 && y <= 2;
  if (seen && x >= 1 && y >= 1 && off >= 1) return 0;
  double best = std::min(to_segment(x, y - 1, 1, 5), to_segment(y, x - 1, 1, 5));
  return seen && off < 1 ? std::min(best, 1 - off) : best;
}

/// The ball has zero clearance across the arms, and some where they meet.
TEST(ZeroClearance, BallInL) {
  const Body room = space::box_body({{{{0, 0, 0}, {6, 2, 4}}}, {{{0, 0, 0}, {2, 6, 4}}}});
  const PairDistances pair = solid_pair(space::shared(ball(1)), space::shared(room));
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> pick(-7, 57);
  int exact = 0;
  for (int n = 0; n < 100; ++n) {
    const std::int64_t x = pick(random), y = pick(random), z = pick(random);
    const double in_plane = to_places_in_l(double(x) / 7, double(y) / 7), up = double(z) / 7;
    const double expected = std::hypot(in_plane, up - std::clamp(up, 1.0, 3.0));
    if (expected < 1e-6) continue;
    const auto v = pair.value(Which::kEta1, space::place(x, y, z, 7));
    ASSERT_TRUE(v);
    EXPECT_NEAR(v->value.to_double(), expected, 1e-9) << x << ' ' << y << ' ' << z;
    ASSERT_TRUE(v->nearest);
    EXPECT_LE(pair.value(Which::kEta1, *v->nearest)->value.sign(), 0);
    exact += v->proven;
  }
  EXPECT_GT(exact, 50);
}

/// On lines by the same values.
TEST(ZeroClearance, SignsOnLines) {
  const Body room = space::box_body({{{{0, 0, 0}, {6, 2, 4}}}, {{{0, 0, 0}, {2, 6, 4}}}}), b = ball(1);
  const space::RayGrid grid{2, 7, 3, 2, 13, 9, 3, 2};
  const auto rays = ray_sign_map(Which::kEta1, Real(1), b, room, grid);
  int negative = 0;
  for (int j = 0; j < grid.nv; ++j) {
    const space::RayRow row = rays->row(j);
    for (int i = 0; i < grid.nu; ++i) {
      const double in_plane = to_places_in_l(double(grid.u_at(i)) / 7, double(grid.v_at(j)) / 7);
      for (int z = -4; z <= 20; ++z) {
        const double up = z / 4.0, gap = std::hypot(in_plane, up - std::clamp(up, 1.0, 3.0)) - 1;
        if (std::fabs(gap) < 1e-6) continue;
        const int sign = space::sign_at(row, i, Real::ratio(7 * z, 4));
        EXPECT_EQ(sign, gap < 0 ? -1 : 1);
        negative += sign < 0;
      }
    }
  }
  EXPECT_GT(negative, 10);
}

/// {0 <= x + y <= k} and a small box far off: no grid holds the planes in the middle, and widths are irrational.
Body slanted_slot(std::int64_t k, std::int64_t size) {
  Body a;
  std::vector<Point> points;
  for (const std::int64_t s : {std::int64_t(0), k}) {
    for (const std::int64_t d : {-2 * size, 2 * size}) {
      for (const std::int64_t z : {std::int64_t(0), 3 * size}) points.push_back({(s + d) / 2, (s - d) / 2, z});
    }
  }
  a.parts.push_back(space::part_of(points, Real()));
  a.parts.push_back(
      {space::box_polytope({{{10 * size, 10 * size, 10 * size}, {11 * size, 11 * size, 11 * size}}}), {}, Real()});
  return a;
}

/// 2p / sqrt 2 less 2q for the fractions p/q next to sqrt 2: less clearance than numbers tell from none, or as little
/// too little. Every other time the ball fits.
TEST(ZeroClearance, BallBetweenSlantedPlanes) {
  int fits = 0, undecided = 0;
  for (std::int64_t p = 1, q = 1; q < 100'000'000; p += 2 * q, q = p - q) {
    if (q < 10) continue;
    const bool has_clearance = p * p - 2 * q * q > 0;
    Body far = slanted_slot(2 * p, 2 * q);
    far.parts[1] = {space::box_polytope({{{20 * q, 20 * q, 20 * q}, {21 * q, 21 * q, 21 * q}}}), {}, Real()};
    const PairDistances pair = solid_pair(space::shared(ball(q)), space::shared(far));
    const auto from = space::place(7, -3, 6 * q, 3);
    const double expected = double(q) - 4 / (3 * std::sqrt(2.0)), error = 1e-9 * double(q);
    const auto v = pair.value(Which::kEta1, from);
    if (v && !v->bounds().upper) {
      EXPECT_FALSE(has_clearance) << p << '/' << q;
      EXPECT_NEAR(v->bounds().lower->to_double(), expected, error);
      ++undecided;
      continue;
    }
    EXPECT_EQ(v.has_value(), has_clearance) << p << '/' << q;
    if (!v) continue;
    ++fits;
    ASSERT_TRUE(v->nearest);
    EXPECT_LE(pair.value(Which::kEta1, *v->nearest)->value.sign(), 0);
    EXPECT_NEAR(v->value.to_double(), expected, error);
  }
  EXPECT_GT(fits, 8);
  EXPECT_GT(undecided, 2);
}

}  // namespace distance_zero_clearance
}  // namespace findspace::distance
