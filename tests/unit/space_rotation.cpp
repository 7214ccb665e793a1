// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rotations of space: exact ones are orthogonal matrices of rationals; what is none is refused.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "space/shape/rotation.h"

namespace findspace::space {
namespace {

using exact::Real;

RealVector vector(int x, int y, int z) { return {Real(x), Real(y), Real(z)}; }

void expect_equal(const RealVector& a, const RealVector& b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(compare(a[k], b[k]), 0) << k << ": " << a[k].text();
}

void expect_rotation(const Rotation& r) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(compare(dot(r.rows[i], r.rows[j]), Real(i == j ? 1 : 0)), 0) << i << " " << j;
  EXPECT_GT(dot(cross(r.rows[0], r.rows[1]), r.rows[2]).sign(), 0);
}

TEST(Rotation, QuartersAboutAxesAreExact) {
  const Rotation r = Rotation::about_axis(2, Real(90), {1, 0, 0});
  EXPECT_FALSE(r.rounded);
  EXPECT_TRUE(r.keeps_axes());
  EXPECT_TRUE(r.keeps_z());
  expect_equal(r(vector(2, 0, 5)), vector(1, 1, 5));
  EXPECT_FALSE(Rotation::about_axis(0, Real(90), {}).keeps_z());
  expect_equal(Rotation::about_axis(0, Real(90), {})(vector(0, 1, 0)), vector(0, 0, 1));
  expect_equal(Rotation::about_axis(1, Real(90), {})(vector(0, 0, 1)), vector(1, 0, 0));
}

TEST(Rotation, AThirdAboutADiagonalPermutesTheAxes) {
  for (const int size : {1, 7}) {
    const Rotation r = Rotation::about_direction(vector(size, size, size), Real(120), {});
    EXPECT_FALSE(r.rounded);
    EXPECT_TRUE(r.keeps_axes());
    expect_equal(r(vector(1, 2, 3)), vector(3, 1, 2));
  }
  expect_equal(Rotation::about_direction(vector(1, 1, 1), Real(-120), {})(vector(1, 2, 3)), vector(2, 3, 1));
}

TEST(Rotation, HalfTurnsAboutAnyDirectionAreExact) {
  const Rotation r = Rotation::about_direction(vector(1, 2, 3), Real(180), {});
  EXPECT_FALSE(r.rounded);
  expect_rotation(r);
  expect_equal(r(vector(1, 2, 3)), vector(1, 2, 3));
  expect_equal(r.linear(r.linear(vector(5, -1, 2))), vector(5, -1, 2));
}

TEST(Rotation, QuartersAboutDirectionsOfWholeLength) {
  const Rotation r = Rotation::about_direction(vector(2, 3, 6), Real(90), {});
  EXPECT_FALSE(r.rounded);
  expect_rotation(r);
  EXPECT_TRUE(Rotation::about_direction(vector(1, 1, 0), Real(90), {}).rounded);
}

TEST(Rotation, OtherAnglesAreNearRotationsWithTheirAxis) {
  const Rotation r = Rotation::about_direction(vector(1, 1, 0), Real(33), {});
  EXPECT_TRUE(r.rounded);
  expect_rotation(r);
  expect_equal(r(vector(4, 4, 0)), vector(4, 4, 0));
  const double trace = (r.rows[0][0] + r.rows[1][1] + r.rows[2][2]).to_double();
  EXPECT_NEAR((trace - 1) / 2, 0.83867056794542402964, 1e-14);
}

TEST(Rotation, QuaternionsOfAnyLength) {
  const Rotation r = Rotation::of_quaternion({Real(1), Real(2), Real(3), Real(4)}, {});
  expect_rotation(r);
  expect_equal(r(vector(2, 3, 4)), vector(2, 3, 4));
  EXPECT_EQ(compare(r.rows[0][0], Real::ratio(-20, 30)), 0);
  EXPECT_THROW(Rotation::of_quaternion({}, {}), Error);
  EXPECT_THROW(Rotation::about_direction({}, Real(90), {}), Error);
}

TEST(Rotation, MatricesMustBeRotationsExactly) {
  const Real c = Real::parse_decimal("0.6"), s = Real::parse_decimal("0.8");
  const Rotation r = Rotation::of_matrix({RealVector{c, -s, Real(0)}, {s, c, Real(0)}, vector(0, 0, 1)}, {10, 0, 0});
  expect_equal(r(vector(10, 0, 0)), vector(10, 0, 0));
  expect_equal(r(vector(15, 0, 0)), vector(13, 4, 0));
  EXPECT_THROW(Rotation::of_matrix({vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, -1)}, {}), Error);
  EXPECT_THROW(Rotation::of_matrix({vector(1, 0, 0), vector(1, 0, 0), vector(0, 0, 1)}, {}), Error);
  EXPECT_THROW(Rotation::of_matrix({RealVector{Real::parse_decimal("0.7071"), Real::parse_decimal("-0.7071"), Real(0)},
                                    {Real::parse_decimal("0.7071"), Real::parse_decimal("0.7071"), Real(0)},
                                    vector(0, 0, 1)},
                                   {}),
               Error);
}

}  // namespace
}  // namespace findspace::space
