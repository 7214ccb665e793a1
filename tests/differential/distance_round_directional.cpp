// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of distances along a slanted direction of round bodies, found by values, against the exact values
// at places of the lines, read off the signs at level 0 on the line along the direction through each.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "distance/planar/translation_value.h"
#include "distance/rays/ray_directional.h"
#include "distance/rays/ray_signs.h"
#include "space/rays/oblique_line.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_round_directional {

using exact::Real;
using space::Body;
using space::Point;
using space::RayGrid;
using space::RayRow;
using space::RealVector;

Body ball(const Point& center, const Real& radius) {
  Body b;
  b.parts.push_back({std::nullopt, center, radius});
  return b;
}

Body capsule(const Point& from, const Point& to, const Real& radius) {
  Body b;
  b.parts.push_back(space::part_of(std::vector<Point>{from, to}, radius));
  return b;
}

Body rounded(Body b, const Real& radius) {
  for (space::BodyPart& part : b.parts) part.radius = radius;
  return b;
}

Body joined(Body b, const Body& more) {
  b.parts.insert(b.parts.end(), more.parts.begin(), more.parts.end());
  return b;
}

struct Case {
  std::string name;
  Which which = Which::kGamma1;
  RealVector direction;
  bool both_ways = true;
  Real level;
};

bool is_farthest(Which which) { return which == Which::kEta2 || which == Which::kDelta2; }

/// The value at p less the level; infinite values are 1000 more or less.
double gap_at(const Case& c, const Body& b, const Body& a, const RealVector& p) {
  RayGrid grid{2, 1, 0, 0, 1, 1, 1, 1};
  grid.oblique = std::make_shared<const space::ObliqueLine>(p, c.direction);
  const Which base = c.which == Which::kEta2 ? Which::kEta1 : c.which == Which::kDelta2 ? Which::kDelta1 : c.which;
  const auto rays = ray_sign_map(base, Real(), b, a, grid);
  const RayRow row = rays->row(0);
  plane::Section line{row.before[0], {}};
  for (const space::RayEvent& e : row.events) line.stops.push_back({e.at.to_real(), e.here, e.after});
  const auto v = translation_value(line, is_farthest(c.which), c.both_ways);
  if (!v) return 1000;
  return v->lowest ? -1000 : (v->value() - c.level).to_double();
}

struct Counts {
  int asked = 0, negative = 0, unresolved = 0;
};

void compare_map(const Case& c, const Body& b, const Body& a, std::mt19937& random, Counts& counts) {
  const RayGrid grid{static_cast<int>(random() % 3), 7, -20, -18, 19, 17, 3, 2};
  const auto rays = ray_directional_map(c.which, c.level, c.direction, c.both_ways, {b, a}, grid).or_throw();
  ASSERT_TRUE(rays->searched()) << c.name;
  const auto axis = static_cast<std::size_t>(grid.axis);
  for (int j = 0; j < grid.nv; ++j) {
    const RayRow row = rays->row(j);
    for (int n = 0; n < 30; ++n) {
      const int i = static_cast<int>(random() % 3);
      const auto z = static_cast<std::int64_t>(random() % 1000) - 400;
      RealVector p;
      p[(axis + 1) % 3] = Real::ratio(grid.u_at(i), 7);
      p[(axis + 2) % 3] = Real::ratio(grid.v_at(j), 7);
      p[axis] = Real::ratio(z, 70);
      const double gap = gap_at(c, b, a, p);
      if (std::fabs(gap) < 1e-6) continue;
      const int sign = space::sign_at(row, i, Real::ratio(z, 10));
      ++counts.asked;
      counts.negative += gap < 0;
      counts.unresolved += sign == 0;
      EXPECT_TRUE(sign == 0 || (sign < 0) == (gap < 0))
          << c.name << (c.both_ways ? " along " : " toward ") << static_cast<int>(c.which) << " at level "
          << c.level.to_double() << ", " << p[0].text() << ' ' << p[1].text() << ' ' << p[2].text() << ": " << sign
          << ", gap " << gap;
    }
  }
}

Counts compare_all(const std::string& name, Which which, const std::vector<Real>& levels, const Body& b,
                   const Body& a) {
  Counts counts;
  std::mt19937 random(7);
  for (const RealVector& way : {space::place(1, 2, -1), space::place(0, 0, -5)}) {
    for (const bool both_ways : {true, false}) {
      for (const Real& level : levels) compare_map({name, which, way, both_ways, level}, b, a, random, counts);
    }
  }
  EXPECT_GT(counts.asked, 100);
  EXPECT_LE(counts.unresolved, counts.asked / 50);
  return counts;
}

TEST(RoundDirectional, DepthInUnions) {
  const Body balls = joined(ball({-3, 0, 0}, Real(3)), ball({3, 1, 0}, Real(2)));
  const std::vector<Real> levels{Real::ratio(-1, 2), Real(-2)};
  EXPECT_GT(compare_all("ball", Which::kGamma1, levels, ball({}, Real(1)), balls).negative, 20);
  EXPECT_GT(compare_all("rounded box", Which::kGamma1, levels,
                        rounded(space::box_body({{{{-1, -1, -1}, {1, 2, 1}}}}), Real(1)), balls)
                .negative,
            40);
  const Body boxes = space::box_body({{{{0, 0, 0}, {6, 2, 4}}}, {{{0, 0, 0}, {2, 6, 4}}}});
  EXPECT_GT(compare_all("capsule", Which::kGamma1, levels, capsule({-1, 0, 0}, {1, 1, 0}, Real(1)), boxes).negative,
            40);
}

Body room() { return space::box_body({{{{-6, -6, -6}, {6, 1, 6}}}, {{{-6, -6, -6}, {0, 6, 6}}}}); }

TEST(RoundDirectional, FitsInRooms) {
  const Body b = joined(ball({}, Real(1)), capsule({0, 0, 0}, {2, 0, 1}, Real::ratio(1, 2)));
  EXPECT_GT(compare_all("room", Which::kEta1, {Real(-1), Real(3)}, b, room()).negative, 20);
  EXPECT_GT(compare_all("room", Which::kEta2, {Real(4), Real(7)}, b, room()).negative, 20);
  EXPECT_GT(compare_all("covered", Which::kDelta1, {Real(-1), Real(2)}, room(), b).negative, 20);
}

TEST(RoundDirectional, FitsInConvexRoundOnes) {
  const Body a = rounded(space::box_body({{{{-3, -2, -3}, {3, 2, 4}}}}), Real(2));
  const Body small = joined(space::box_body({{{{-1, -1, -1}, {1, 1, 1}}}}), ball({1, 0, 1}, Real(1)));
  EXPECT_GT(compare_all("rounded", Which::kEta1, {Real(-1), Real(2)}, small, a).negative, 20);
  EXPECT_GT(compare_all("rounded", Which::kEta2, {Real(5)}, small, a).negative, 20);
  EXPECT_GT(compare_all("rounder", Which::kEta1, {Real(-1), Real(2)}, ball({}, Real(3)), a).negative, 20);
  EXPECT_GT(compare_all("ball", Which::kEta1, {Real(-1), Real(2)}, small, ball({}, Real(6))).negative, 20);
}

/// Of a complement the distances are those of what it leaves, rotated.
TEST(RoundDirectional, Complements) {
  Body hollow = room();
  hollow.outside = true;
  const Body b = ball({}, Real(1));
  EXPECT_GT(compare_all("hollow", Which::kGamma1, {Real(1), Real(-1)}, b, hollow).negative, 20);
  hollow = joined(ball({-3, 0, 0}, Real(3)), ball({3, 1, 0}, Real(2)));
  hollow.outside = true;
  EXPECT_GT(compare_all("outside", Which::kEta1, {Real(1), Real(2)}, b, hollow).negative, 20);
}

}  // namespace distance_round_directional
}  // namespace findspace::distance
