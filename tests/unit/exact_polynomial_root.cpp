// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "exact/number/polynomial_root.h"
#include "exact/number/stages.h"
#include "exact/planar/rotation_polynomial.h"

namespace findspace::exact {
namespace exact_polynomial_root {

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial out(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) out[i + k] += a[i] * b[k];
  return out;
}

TEST(PolynomialRoot, NoneOfConstantsAndOfZero) {
  EXPECT_TRUE(roots_between({}, 0, 1).empty());
  EXPECT_TRUE(roots_between({0, 0, 0}, 0, 1).empty());
  EXPECT_TRUE(roots_between({3}, 0, 1).empty());
  EXPECT_TRUE(roots_between({1, 0, 0, 0, 1}, -5, 5).empty());
}

TEST(PolynomialRoot, EndsAndRationalRootsBelong) {
  const Polynomial p = times(times({0, 1}, {-1, 1}), times({-1, 2}, {-3, 0, 0, 1}));  // 0, 1, 1/2, cube root of 3
  const std::vector<Real> r = roots_between(p, 0, 2);
  ASSERT_EQ(r.size(), 4u);
  EXPECT_EQ(r[0], Real(0));
  EXPECT_EQ(r[1], Real::ratio(1, 2));
  EXPECT_EQ(r[2], Real(1));
  EXPECT_EQ(r[3] * r[3] * r[3], Real(3));
  EXPECT_TRUE(Real::parse_decimal("1.4422495703074083823216") < r[3]);
  EXPECT_TRUE(r[3] < Real::parse_decimal("1.4422495703074083823217"));
}

TEST(PolynomialRoot, MultipleRootsComeOnce) {
  const Polynomial quintic{-1, -1, 0, 0, 0, 1};  // x^5 - x - 1, not solvable in radicals
  const Polynomial cubed = times(times(quintic, quintic), quintic);
  const std::vector<Real> r = roots_between(cubed, -2, 2);
  ASSERT_EQ(r.size(), 1u);
  EXPECT_EQ(value_at(quintic, r[0]).sign(), 0);
  EXPECT_EQ(r[0], roots_between(quintic, -2, 2).at(0));
}

TEST(PolynomialRoot, TouchingZeroIsToldFromMissingIt) {
  const Polynomial q{-2, 0, 1};
  Polynomial p = times(times(q, q), {1, 0, 1});
  EXPECT_EQ(roots_between(p, 1, 2).size(), 1u);
  p[0] += Real::parse_decimal("1e-40");
  EXPECT_TRUE(roots_between(p, 1, 2).empty());
  p[0] -= Real::parse_decimal("2e-40");
  const std::vector<Real> r = roots_between(p, 1, 2);
  ASSERT_EQ(r.size(), 2u);
  EXPECT_TRUE(r[0] * r[0] < Real(2));
  EXPECT_TRUE(Real(2) < r[1] * r[1]);
}

TEST(PolynomialRoot, CoefficientsMayBeIrrational) {
  // (x - 2^(1/4))(x^2 + x + sqrt 3) times sqrt 2, and its root by nested square roots.
  const Real two = sqrt(Real(2)), a = sqrt(two);
  Polynomial p = times(times({-a, 1}, {sqrt(Real(3)), 1, 1}), {1, 0, 1});
  for (Real& c : p) c *= two;
  const std::vector<Real> r = roots_between(p, 0, 2);
  ASSERT_EQ(r.size(), 1u);
  EXPECT_EQ(r[0], a);
  EXPECT_EQ(r[0] * r[0], two);
  EXPECT_NE(r[0], a + Real::parse_decimal("1e-50"));
}

TEST(PolynomialRoot, ArithmeticWithSeveralRoots) {
  const Real c = roots_between({-2, 0, 0, 1}, 0, 2).at(0);     // 2^(1/3)
  const Real d = roots_between({-4, 0, 0, 1}, 0, 2).at(0);     // 4^(1/3)
  const Real e = roots_between({-8, 0, 0, 0, 1}, 0, 2).at(0);  // 8^(1/4)
  stage_counts() = {};
  EXPECT_EQ(c * c, d);
  EXPECT_EQ((c * d - Real(2)).sign(), 0);
  EXPECT_EQ(Real(1) / (c - Real(1)), c * c + c + Real(1));
  EXPECT_EQ(sqrt(d), c);
  EXPECT_EQ(e * e, Real(2) * sqrt(Real(2)));
  EXPECT_GE(stage_counts().zero_bound, 4u);
  EXPECT_EQ((c * d - Real(2) + Real::parse_decimal("1e-60")).sign(), 1);
}

TEST(PolynomialRoot, RandomPolynomialsWithKnownRoots) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> number(-20, 20);
  for (int trial = 0; trial < 24; ++trial) {
    Polynomial p{1};
    std::vector<Real> known;
    for (int k = 0; k < 5; ++k) {
      const Real root = Real::ratio(number(random), 7);
      known.push_back(root);
      for (int again = 0; again <= trial % 3; ++again) p = times(p, {-root, 1});
    }
    p = times(p, {Real(number(random) + 21), 0, 1});
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    const std::vector<Real> found = roots_between(p, -3, 3);
    ASSERT_EQ(found.size(), known.size()) << "trial " << trial;
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k], known[k]) << "trial " << trial;
  }
}

TEST(RotationPolynomial, ZeroesAreTheAngles) {
  // 4 cos^3 - 3 cos = cos of three times the angle.
  constexpr double kQuarter = 1.5707963267948966;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const RotationPolynomial c = RotationPolynomial::linear(0, 1, 0, quarter);
    const RotationPolynomial p = Real(4) * (c * c * c) - Real(3) * c - RotationPolynomial::constant(Real::ratio(1, 2));
    std::vector<ExactAngle> rotations =
        p.rotations_between((quarter - 0.5) * kQuarter, (quarter + 0.5) * kQuarter, quarter);
    std::size_t count = 0;
    for (int degrees : {20, 100, 140, 220, 260, 340}) {
      const double from = 90 * quarter - 45;
      if (std::fmod(degrees - from + 360, 360) <= 90) ++count;
    }
    ASSERT_EQ(rotations.size(), count);
    for (const ExactAngle& t : rotations) {
      const ExactAngle three = t + t + t;
      EXPECT_EQ(three.cos, Real::ratio(1, 2));
      EXPECT_EQ(t.cos * t.cos + t.sin * t.sin, Real(1));
      EXPECT_EQ(compare(Angle{three, {}}, Angle::of_degrees(three.sin.sign() > 0 ? 60 : 300)), 0);
    }
  }
}

}  // namespace exact_polynomial_root
}  // namespace findspace::exact
