// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The first stage of lines and of the corners of offsets: the error bounds hold, also where corners are flat and far
// from the origin, and the points are those that the supporting curves define.
#include <gtest/gtest.h>

#include <random>

#include "exact/planar/geometry_signs.h"
#include "exact/planar/offset_points.h"

namespace findspace::exact {
namespace exact_offset_points {

/// Whether the exact value is as near to the approximate one as that says.
bool holds(const Approx& approx, const Real& exact) {
  const Real off = exact - Real::from_double(approx.value), room = Real::from_double(approx.error);
  return (room - off).sign() >= 0 && (room + off).sign() >= 0;
}

Real length(std::int64_t a, std::int64_t b) { return sqrt(Real(int128(a) * a + int128(b) * b)); }

/// A direction, a corner and lines along two directions there, nearly the same in every third case.
class Corners {
 public:
  struct Way {
    std::int64_t a, b;
  };

  std::int64_t number(std::int64_t range) {
    return std::uniform_int_distribution<std::int64_t>(-range, range)(random_);
  }
  Way way(std::int64_t range) {
    Way w{number(range), number(range)};
    if (w.a == 0 && w.b == 0) w.a = 1;
    make_primitive(w.a, w.b);
    return w;
  }
  Way beside(Way w) {
    w.a += number(1);
    w.b += number(1);
    if (w.a == 0 && w.b == 0) w.b = 1;
    make_primitive(w.a, w.b);
    return w;
  }

 private:
  std::mt19937_64 random_{5};
};

TEST(LineFilter, HoldsTheUnitNormalAndTheDistance) {
  Corners some;
  for (int k = 0; k < 500; ++k) {
    const auto w = some.way(k % 2 ? 9 : std::int64_t(1) << 40);
    const std::int64_t x = some.number(std::int64_t(1) << (k % 55)), y = some.number(std::int64_t(1) << (k % 55));
    Geometry g;
    const std::uint32_t line = g.add_line(w.a, w.b, int128(w.a) * x + int128(w.b) * y);
    const std::uint32_t parallel = g.add_parallel(g.supporting_curves[line], y, x);
    const Real n = length(w.a, w.b);
    for (std::uint32_t l : {line, parallel}) {
      EXPECT_TRUE(holds(g.supporting_curves[l].x(), Real(w.a) / n));
      EXPECT_TRUE(holds(g.supporting_curves[l].y(), Real(w.b) / n));
      EXPECT_TRUE(holds(g.supporting_curves[l].z(), Real(g.supporting_curves[l].c) / n)) << k;
    }
  }
}

TEST(OffsetPoints, TheErrorsHoldAndThePointsAreThoseOfTheSupportingCurves) {
  Corners some;
  int flat = 0;
  for (int k = 0; k < 400; ++k) {
    const auto v = some.way(k % 2 ? 12 : 1 << 20), w = k % 3 ? some.way(1 << 20) : some.beside(v);
    if (v.a == w.a && v.b == w.b) continue;
    const std::int64_t x = some.number(1 << 30), y = some.number(1 << 30);
    const Real r = k % 5 == 0 ? sqrt(Real(1 + k)) : Real(1 + k) / Real(7), sum = k % 4 < 2 ? r : -r,
               other = k % 2 ? r : -r;
    Geometry g;
    const std::uint32_t p = g.add_line(v.a, v.b, int128(v.a) * x + int128(v.b) * y);
    const std::uint32_t q = g.add_line(w.a, w.b, int128(w.a) * x + int128(w.b) * y);
    const Displacement shift(sum), shift_of_other(other);
    const std::uint32_t i = add_displaced(g, g.supporting_curves[p], shift);
    const std::uint32_t j = add_displaced(g, g.supporting_curves[q], shift_of_other);
    const std::uint32_t circle = add_circle(g, x, y, Displacement(r));
    const std::uint32_t crossing = add_shifted_crossing(g, {i, shift}, {j, shift_of_other}, x, y);
    const std::uint32_t touch = add_shifted_touch(g, {i, shift}, circle, x, y);
    for (std::uint32_t c : {crossing, touch}) {
      const exact::Point& at = g.points[c];
      EXPECT_TRUE(holds({at.x, at.error}, g.exact_x(c)) && holds({at.y, at.error}, g.exact_y(c))) << k;
    }
    EXPECT_EQ(compare_xy(g, crossing, g.add_crossing(i, j, 0)), 0) << k;
    EXPECT_EQ(compare_xy(g, touch, g.add_crossing(i, circle, 0)), 0) << k;
    EXPECT_EQ(side(g, touch, circle), 0) << k;
    flat += g.points[g.add_crossing(i, j, 0)].error > 16 * g.points[crossing].error;
  }
  EXPECT_GT(flat, 20) << "flat corners, whose crossings of two lines are less near, were among them";
}

}  // namespace exact_offset_points
}  // namespace findspace::exact
