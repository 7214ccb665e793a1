// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Zeros of roots by algebra: where there is an identity it is found, and nothing else counts as one.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "exact/number/expression_sign.h"
#include "exact/number/polynomial_root.h"
#include "exact/number/stages.h"
#include "exact/number/zero_proof.h"
#include "exact/planar/angle.h"

namespace findspace::exact {
namespace exact_zero_proof {

bool proven(const Real& x) { return detail::proves_zero(detail::Plan(x)); }

Real root(int128 n) { return sqrt(Real(n)); }

TEST(ZeroProof, OfMoreRootsWhereThatIsAskedFor) {
  Real a, b;
  for (const int n : {2, 3, 5, 7, 11}) a += sqrt(Real(n));
  for (const int n : {13, 17, 19, 23, 29}) b += sqrt(Real(n));
  const Real x = (a + b) * (a + b) - a * a - Real(2) * a * b - b * b;
  EXPECT_FALSE(proven(x));
  EXPECT_TRUE(detail::proves_zero(detail::Plan(x), 4096));
  EXPECT_FALSE(detail::proves_zero(detail::Plan(x - Real::ratio(1, 1000000)), 4096));
}

TEST(ZeroProof, SumsOfRoots) {
  const Real a = root(2) + root(3), b = root(5) + root(7);
  EXPECT_TRUE(proven(a * b - root(2) * b - root(3) * b));
  EXPECT_TRUE(proven((a + b) * (a + b) - a * a - b * b - Real(2) * (a * b)));
  EXPECT_FALSE(proven(a * b - root(2) * b));
  EXPECT_FALSE(proven(a - b));
}

TEST(ZeroProof, NestedRootsAndQuotients) {
  const Real a = sqrt(Real(3) + root(2)), b = sqrt(a + root(5)), c = (a - b) / (a + b * root(7));
  EXPECT_TRUE(proven(b * b - a - root(5)));
  EXPECT_TRUE(proven(c * (a + b * root(7)) - a + b));
  EXPECT_TRUE(proven(Real(1) / c - (a + b * root(7)) / (a - b)));
  EXPECT_TRUE(proven(sqrt(a / b) * sqrt(a / b) * b - a));
  EXPECT_FALSE(proven(c * (a + b * root(7)) - a - b));
}

/// No identities of the roots as they stand, but the value times those with other signs of the roots is 0.
TEST(ZeroProof, RootsThatLieInTheFieldOfOthers) {
  const Real x = sqrt(Real(5) + Real(2) * root(6));
  EXPECT_TRUE(proven(x - root(2) - root(3)));
  EXPECT_FALSE(proven(x - root(3) + root(2)));
  EXPECT_FALSE(proven(x + root(2) - root(3)));
  const Real y = sqrt(Real(3) + root(2)), z = sqrt((y + root(7)) * (y + root(7)) / (y + 1));
  EXPECT_TRUE(proven(z * z * (y + 1) - (y + root(7)) * (y + root(7))));
  EXPECT_TRUE(proven(z * sqrt(y + 1) - y - root(7)));
  EXPECT_FALSE(proven(z * sqrt(y + 1) + y - root(7)));
}

/// A root of a polynomial that has factors: the bound tells.
TEST(ZeroProof, NotOfOneFactorOfAPolynomial) {
  const std::vector<Real> x = roots_between({Real(6), Real(0), Real(-5), Real(0), Real(1)}, Real(1), Real::ratio(3, 2));
  ASSERT_EQ(x.size(), 1u);
  EXPECT_FALSE(proven(x[0] - root(2)));
  EXPECT_EQ((x[0] - root(2)).sign(), 0);
}

/// A point rotated by the angle that puts it onto a circle lies on it; the point and the radius being made of roots.
TEST(ZeroProof, RotatedPointsLieWhereTheyWereRotatedTo) {
  std::mt19937 random(5);
  const auto number = [&] { return Real(std::uniform_int_distribution<int>(1, 1 << 20)(random)); };
  stage_counts() = {};
  for (int trial = 0; trial < 20; ++trial) {
    const Real x = number() + sqrt(number()), y = number() - sqrt(number()), level = number() / Real(3);
    for (const ExactAngle& t : rotations_where(x, y, level)) {
      const Real off = x * t.cos + y * t.sin - level, unit = t.cos * t.cos + t.sin * t.sin - 1;
      EXPECT_EQ(off.sign(), 0);
      EXPECT_EQ(unit.sign(), 0);
      EXPECT_EQ((off + Real::ratio(1, int128(1) << 100)).sign(), 1);
    }
  }
  EXPECT_GT(stage_counts().zero_identity, 20u);
}

/// Values of polynomials at their roots, and what follows from them; with roots among the coefficients, and several.
TEST(ZeroProof, RootsOfPolynomials) {
  const Polynomial p{Real(-7), root(3), Real(0), Real::ratio(5, 3), Real(1), root(2) + 1};
  const Polynomial q{Real(-11), Real(2), Real(4) * root(5), Real(3)};
  const std::vector<Real> x = roots_between(p, Real(0), Real(4)), y = roots_between(q, Real(0), Real(4));
  ASSERT_EQ(x.size(), 1u);
  ASSERT_EQ(y.size(), 1u);
  const Real f = value_at(p, x[0]), g = value_at(q, y[0]);
  EXPECT_TRUE(proven(f * root(7) - g / (x[0] + y[0])));
  EXPECT_TRUE(proven((x[0] + y[0]) * (x[0] - y[0]) - x[0] * x[0] + y[0] * y[0]));
  EXPECT_TRUE(proven(sqrt(x[0]) * sqrt(x[0]) / y[0] - x[0] / y[0] + f));
  EXPECT_FALSE(proven(f + Real::ratio(1, int128(1) << 90)));
  EXPECT_FALSE(proven(value_at(p, y[0])));
  EXPECT_FALSE(proven(x[0] * x[0] - y[0]));
}

/// Random expressions, of which many are 0: what is proven is 0 by the bound, too, and what is not 0 is never proven.
TEST(ZeroProof, NeverOfWhatIsNotZero) {
  std::mt19937 random(11);
  const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  int zeros = 0, others = 0;
  for (int trial = 0; trial < 12000; ++trial) {
    // Roots of products, so that some are combinations of others.
    std::vector<Real> made{Real(pick(4) + 1), root(pick(3) + 2), root(pick(5) + 5), root(6), root(10) + root(15)};
    for (int k = 0; k < 6; ++k) {
      const Real a = made[std::size_t(pick(int(made.size())))], b = made[std::size_t(pick(int(made.size())))];
      const int what = pick(5);
      if (what == 3 && b.sign() == 0) continue;
      if (what == 4 && a.sign() <= 0) continue;
      made.push_back(what == 0 ? a + b : what == 1 ? a - b : what == 2 ? a * b : what == 3 ? a / b : sqrt(a));
    }
    const Real x =
        made.back() * made[3 % made.size()] - made[made.size() - 1] * made[std::size_t(pick(4)) % made.size()];
    if (detail::separation_bits(x) > 1000) continue;  // more, and sign() asks for a proof itself
    if (proven(x)) {
      EXPECT_EQ(x.sign(), 0) << "trial " << trial;
      ++zeros;
    } else {
      ++others;
    }
  }
  EXPECT_GT(zeros, 200);
  EXPECT_GT(others, 200);
}

}  // namespace exact_zero_proof
}  // namespace findspace::exact
