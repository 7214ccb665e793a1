// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "exact/planar/geometry_signs.h"

namespace findspace::exact {
namespace exact_geometry {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Two numbers that are nearer to each other than their doubles tell.
const Real kIrrational = sqrt(Real(2)) + sqrt(Real(3)), kRational = Real::parse_decimal("3.1462643699419723419");

void expect_near(const Approx& near, const Real& exact) {
  EXPECT_LT(near.error, 1e-6);
  EXPECT_TRUE(abs(Real::from_double(near.value) - exact) <= Real::from_double(near.error));
}

void expect_near(const Geometry& g, std::uint32_t point) {
  const Point& p = g.points[point];
  const RealPoint exact = g.exact(point);
  expect_near({p.x, p.error}, exact.x);
  expect_near({p.y, p.error}, exact.y);
}

TEST(Approx, TheRootOfTheUnknownIsUnknown) {
  for (const Approx& p : {Approx{0, kInfinity}, {0, kNaN}, {4, kInfinity}, {4, kNaN}, {kNaN, kNaN}}) {
    EXPECT_EQ(sqrt(p).error, kInfinity);
    EXPECT_FALSE(sqrt(p).certain());
  }
  EXPECT_EQ(sqrt(Approx{4, 0}).value, 2);
  EXPECT_EQ(sqrt(Approx{-1, 5}).error, 2 * Approx::kGrow);
}

TEST(Geometry, LinesThroughGridPointsHoldWhatTheyAre) {
  std::mt19937_64 rng(3);
  Geometry g;
  for (int size = 2; size <= 40; size += 3) {
    const std::int64_t most = std::int64_t(1) << size;
    auto number = [&] { return std::int64_t(rng() % std::uint64_t(2 * most)) - most; };
    const auto first = std::uint32_t(g.points.size()), line = std::uint32_t(g.supporting_curves.size());
    g.add_grid_point(-most, most);
    for (int k = 0; k < 40; ++k) g.add_grid_point(number(), g.points.back().gy == most ? -most : most);
    g.add_lines(first, 41, first + 1);
    ASSERT_EQ(g.supporting_curves.size(), line + 41);
    for (std::uint32_t k = 0; k < 41; ++k) {
      const SupportingCurve& l = g.supporting_curves[line + k];
      EXPECT_TRUE(lies_on(g, first + k, line + k) && lies_on(g, k == 40 ? first + 1 : first + k + 1, line + k)) << k;
      EXPECT_TRUE(std::gcd(l.a, l.b) == 1 && (l.a > 0 || (l.a == 0 && l.b == 1))) << l.a << " " << l.b;
      const Real length = sqrt(Real(int128(l.a) * l.a + int128(l.b) * l.b));
      expect_near(l.x(), Real(l.a) / length);
      expect_near(l.y(), Real(l.b) / length);
      EXPECT_TRUE(abs(Real::from_double(l.z().value) - Real(l.c) / length) <= Real::from_double(l.z().error));
    }
  }
}

TEST(Geometry, OfNumbersThatDoublesDoNotEnclose) {
  const Real r = (kIrrational - Real::parse_decimal("3.14626436994197234")) / (kIrrational - kRational);
  ASSERT_EQ(r.interval().hi, kInfinity);
  EXPECT_NEAR(r.to_double(), 5.4, 0.1);
  Geometry g;
  const auto line = g.add_line(0, 1, 3), circle = g.add(SupportingCurve::circle_at(0, 0, r));
  expect_near(g.supporting_curves[circle].z(), r);
  const auto left = g.add_crossing(line, circle, -1), right = g.add_crossing(line, circle, 1);
  expect_near(g, left);
  expect_near(g, right);
  EXPECT_NE(compare_x(g, left, right), 0);
  expect_near(g, g.add_real_point(r, Real(1)));
  expect_near(g, g.add_real_point(Real(1), r));
}

TEST(Geometry, CrossingsOfCirclesWithCentresThatDoublesDoNotTellApart) {
  Geometry g;
  g.add(SupportingCurve::circle_at(kIrrational, Real(0), Real(5)));
  g.add(SupportingCurve::circle_at(kRational, Real(0), Real(5)));
  ASSERT_EQ(meet(g, 0, 1).count, 2);
  for (const int root : {-1, 1}) {
    const auto p = g.add_crossing(0, 1, root);
    expect_near(g, p);
    EXPECT_NEAR(std::abs(g.points[p].y), 5, 1e-9);
  }
}

/// Of arcs whose ends were rounded after a rotation: by the formulas in doubles they would cross far from there.
TEST(Geometry, CrossingsOfCirclesThatNearlyCoincideAreKnown) {
  Geometry g;
  const Real radius(245760000000), x = Real::ratio(-1684739756927, 100), y = Real::ratio(-10148507816323, 100);
  g.add(SupportingCurve::circle_at(x, y, radius));
  g.add(SupportingCurve::circle_at(x - Real::ratio(2, 100), y - Real::ratio(41, 100), radius));
  ASSERT_EQ(meet(g, 0, 1).count, 2);
  for (const int root : {-1, 1}) {
    const auto p = g.add_crossing(0, 1, root);
    const RealPoint at = g.exact(p);
    EXPECT_NEAR(g.points[p].x, at.x.to_double(), 0.001);
    EXPECT_NEAR(g.points[p].y, at.y.to_double(), 0.001);
    EXPECT_LT(double(g.points[p].error), 0.001);
  }
}

/// Crossings of displaced lines and of circles in rows and columns of equal shapes: many share a coordinate.
TEST(Geometry, CrossingsOfMovedCurvesAreComparedAsTheirCoordinates) {
  Geometry g;
  const CurveReals far(Real::ratio(7, 2)), other(Real::ratio(14, 4)), root(sqrt(Real(11)));
  std::vector<std::uint32_t> points;
  for (const CurveReals& w : {far, other, root})
    for (std::int64_t x : {0, 5, 9})
      for (std::int64_t y : {0, 5, 7}) {
        const auto steep = g.add(SupportingCurve::displaced_line(1, 0, x, w));
        const auto level = g.add(SupportingCurve::displaced_line(0, 1, y, w));
        const auto slant = g.add(SupportingCurve::displaced_line(2, -3, 2 * x - 3 * y, w));
        const auto ring = g.add(SupportingCurve::circle_at(x, y, w)),
                   right = g.add(SupportingCurve::circle_at(x + 4, y, w)),
                   above = g.add(SupportingCurve::circle_at(x, y + 4, w)), line = g.add_line(1, 1, x + y + 1),
                   upright = g.add_line(1, 0, x + 2), mirrored = g.add_line(1, 0, x - 2),
                   beside = g.add_line(0, 1, y + 7), flat = g.add_line(0, 1, y + 2);
        for (const auto& [i, k] : {std::pair{steep, level}, {level, slant}, {steep, slant}})
          points.push_back(g.add_crossing(i, k, 0));
        const auto large = g.add(SupportingCurve::circle_at(x, y, Real(7)));
        points.push_back(g.add_crossing(beside, large, 0));
        for (const int way : {-1, 1})
          for (const auto& [i, k] : {std::pair{ring, right},
                                     {ring, above},
                                     {right, above},
                                     {line, ring},
                                     {upright, ring},
                                     {mirrored, ring},
                                     {flat, ring},
                                     {flat, right}})
            points.push_back(g.add_crossing(i, k, way));
      }
  for (const std::uint32_t p : points)
    for (const std::uint32_t q : points) {
      const RealPoint at = g.exact(p), by = g.exact(q);
      EXPECT_EQ(compare_x(g, p, q), compare(at.x, by.x)) << p << " " << q;
      EXPECT_EQ(compare_y(g, p, q), compare(at.y, by.y)) << p << " " << q;
    }
}

}  // namespace exact_geometry
}  // namespace findspace::exact
