// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Lines that are reduced late are those that are made at once, number by number, and so are their crossings; and the
// sides and rough crossings of segments agree with signs and crossings by lines.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "exact/planar/geometry_signs.h"
#include "exact/planar/segment_sides.h"
#include "exact/planar/unreduced_lines.h"

namespace findspace::exact {
namespace exact_unreduced_lines {

struct Segment {
  std::int64_t x, y, to_x, to_y;
};

/// Not a point; p0 is the first in lexicographic order. Often its normal has a divisor.
Segment segment(std::mt19937_64& rng, std::int64_t size) {
  const auto number = [&] { return std::int64_t(rng() % std::uint64_t(2 * size + 1)) - size; };
  for (;;) {
    const Segment s{number(), number(), number(), number()};
    if (s.x < s.to_x || (s.x == s.to_x && s.y < s.to_y)) return s;
  }
}

std::uint32_t add_at_once(Geometry& g, const Segment& s) {
  std::int64_t a = s.to_y - s.y, b = s.x - s.to_x;
  make_primitive(a, b);
  return g.add_line(a, b, int128(a) * s.x + int128(b) * s.y);
}

std::uint32_t add_unreduced(Geometry& g, const Segment& s) {
  set_unreduced_line(g.supporting_curves.emplace_back(), s.x, s.y, s.to_x, s.to_y);
  return std::uint32_t(g.supporting_curves.size() - 1);
}

void add_ends(Geometry& g, const Segment& s) {
  g.add_grid_point(s.x, s.y);
  g.add_grid_point(s.to_x, s.to_y);
}

void expect_same(const Approx& p, const Approx& q) {
  EXPECT_EQ(p.value, q.value);
  EXPECT_EQ(p.error, q.error);
}

void expect_same(const SupportingCurve& k, const SupportingCurve& l) {
  EXPECT_EQ(k.a, l.a);
  EXPECT_EQ(k.b, l.b);
  EXPECT_TRUE(k.c == l.c);
  expect_same(k.x(), l.x());
  expect_same(k.y(), l.y());
  expect_same(k.z(), l.z());
}

void expect_same(const Point& p, const Point& q) {
  EXPECT_EQ(p.kind, q.kind);
  EXPECT_EQ(p.i, q.i);
  EXPECT_EQ(p.j, q.j);
  EXPECT_EQ(p.x, q.x);
  EXPECT_EQ(p.y, q.y);
  EXPECT_EQ(std::signbit(p.x), std::signbit(q.x));
  EXPECT_EQ(std::signbit(p.y), std::signbit(q.y));
  EXPECT_EQ(double(p.error), double(q.error));
}

int sign(int128 k) { return (k > 0) - (k < 0); }

template <class Integer>
void expect_sides(const Geometry& g, std::uint32_t p, std::uint32_t q) {
  const auto sides = segment_sides<Integer>(g.points[0], g.points[1], g.points[2], g.points[3]);
  const int left_of_p = g.supporting_curves[p].b > 0 ? 1 : -1, left_of_q = g.supporting_curves[q].b > 0 ? 1 : -1;
  EXPECT_EQ(sign(sides.q0), left_of_p * side(g, 2, p));
  EXPECT_EQ(sign(sides.q1), left_of_p * side(g, 3, p));
  EXPECT_EQ(sign(sides.p0), left_of_q * side(g, 0, q));
  EXPECT_EQ(sign(sides.p1), left_of_q * side(g, 1, q));
  EXPECT_EQ(sides.parallel, are_parallel(g.supporting_curves[p], g.supporting_curves[q]));
  EXPECT_EQ(sides.apart(), side(g, 2, p) * side(g, 3, p) > 0 || side(g, 0, q) * side(g, 1, q) > 0);
  if (sides.parallel || sides.apart()) return;
  const Point rough = rough_crossing(q, p, g.points[0], g.points[1], sides), fine = g.crossing(p, q, 0);
  EXPECT_EQ(rough.i, fine.i);
  EXPECT_EQ(rough.j, fine.j);
  const double error = double(rough.error) + double(fine.error);
  EXPECT_LE(std::abs(rough.x - fine.x), error);
  EXPECT_LE(std::abs(rough.y - fine.y), error);
}

TEST(ExactUnreducedLines, AreLinesOnceReduced) {
  std::mt19937_64 rng(1);
  int crossings = 0;
  for (const int bits : {2, 4, 20, 29, 39}) {
    const std::int64_t size = std::int64_t(1) << bits;
    for (int k = 0; k < 2000; ++k) {
      const std::array<Segment, 2> both{segment(rng, size), segment(rng, size)};
      Geometry at_once, late;
      for (const Segment& s : both) {
        add_ends(at_once, s);
        add_ends(late, s);
        add_at_once(at_once, s);
        add_unreduced(late, s);
      }
      expect_sides<int128>(at_once, 0, 1);
      expect_sides<int128>(late, 0, 1);
      if (bits < 30) {
        EXPECT_TRUE(has_narrow_sides(late.points[0]));
        expect_sides<std::int64_t>(late, 0, 1);
      }
      const bool cross = !are_parallel(late.supporting_curves[0], late.supporting_curves[1]);
      std::vector<std::uint32_t> points;
      if (cross) {
        ++crossings;
        at_once.add_crossing(1, 0, 0);
        points.push_back(late.add_crossing(1, 0, 0));
        EXPECT_EQ(compare_x(late, 0, 4), compare_x(at_once, 0, 4));
        EXPECT_EQ(compare_y(late, 3, 4), compare_y(at_once, 3, 4));
      }
      reduce_lines(late, std::array<std::uint32_t, 3>{0, 1, 0}, points);
      for (int l : {0, 1}) expect_same(at_once.supporting_curves[l], late.supporting_curves[l]);
      if (cross) expect_same(at_once.points[4], late.points[4]);
    }
  }
  EXPECT_GT(crossings, 9000);
}

TEST(ExactUnreducedLines, HaveSidesOfCrossings) {
  std::mt19937_64 rng(2);
  for (int k = 0; k < 3000; ++k) {
    Geometry at_once, late;
    for (int s = 0; s < 3; ++s) {
      const Segment some = segment(rng, k % 2 ? 6 : 1 << 30);
      add_at_once(at_once, some);
      add_unreduced(late, some);
    }
    if (are_parallel(late.supporting_curves[0], late.supporting_curves[1])) continue;
    at_once.add_crossing(0, 1, 0);
    late.add_crossing(0, 1, 0);
    EXPECT_EQ(side(at_once, 0, 2), side(late, 0, 2));
  }
}

}  // namespace exact_unreduced_lines
}  // namespace findspace::exact
