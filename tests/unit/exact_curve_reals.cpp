// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "exact/planar/curve_reals.h"
#include "exact/planar/geometry.h"

namespace findspace::exact {
namespace exact_curve_reals {

TEST(ErrorBound, IsNeverBelowAndHardlyAbove) {
  std::mt19937_64 random(7);
  for (int k = 0; k < 100000; ++k) {
    const double error = std::ldexp(1 + double(random() >> 12) * 0x1p-52, int(random() % 250) - 125);
    const double bound = ErrorBound(error);
    ASSERT_GE(bound, error);
    ASSERT_LE(bound, error * (1 + 0x1p-21));
    ASSERT_EQ(double(ErrorBound(bound)), bound);
  }
}

TEST(ErrorBound, KeepsZeroTheSmallestAndTheInfinite) {
  EXPECT_EQ(double(ErrorBound()), 0);
  EXPECT_EQ(double(ErrorBound(0)), 0);
  for (const double tiny : {0x1p-1074, 0x1p-1000, 0x1p-149, 0x1p-148 + 0x1p-180, 0x1p-127}) {
    EXPECT_GE(double(ErrorBound(tiny)), tiny);
    EXPECT_LE(double(ErrorBound(tiny)), 0x1p-126);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(double(ErrorBound(infinity)), infinity);
  EXPECT_EQ(double(ErrorBound(std::numeric_limits<double>::max())), infinity);
}

TEST(CurveReals, OfNoneThereIsZeroAndNoPoint) {
  for (const CurveReals& none : {CurveReals(), CurveReals(Real())}) {
    EXPECT_EQ(none.w().sign(), 0);
    EXPECT_EQ(none.point(), nullptr);
  }
}

TEST(CurveReals, CopiesShareWhatOutlivesTheFirst) {
  SupportingCurve second;
  const Real* shared = nullptr;
  {
    const CurveReals radius(Real::ratio(1, 3));
    const SupportingCurve first = SupportingCurve::circle_at(1, 2, radius);
    second = SupportingCurve::circle_at(3, 4, radius);
    shared = &first.w();
  }
  EXPECT_EQ(&second.w(), shared);
  EXPECT_TRUE(second.w() == Real::ratio(1, 3));
  second = SupportingCurve::line(1, 2, Real::ratio(1, 7));
  ASSERT_NE(second.real(), nullptr);
  EXPECT_TRUE(second.offset() == Real::ratio(1, 7));
  EXPECT_EQ(second.w().sign(), 0);
}

TEST(CurveReals, CirclesKeepCentreAndRadius) {
  const SupportingCurve k = SupportingCurve::circle_at(Real::ratio(1, 2), Real(3), Real(5));
  EXPECT_FALSE(k.grid);
  EXPECT_TRUE(k.center_x() == Real::ratio(1, 2) && k.center_y() == Real(3) && k.w() == Real(5));
  const SupportingCurve copy = k;
  EXPECT_TRUE(same_supporting_curve(k, copy));
  EXPECT_EQ(&copy.w(), &k.w());
}

}  // namespace exact_curve_reals
}  // namespace findspace::exact
