// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Zeros of nested roots by algebra: where there is an identity it is found, and nothing else counts as one.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "exact/angle.h"
#include "exact/real_sign.h"
#include "exact/stages.h"
#include "exact/zero_proof.h"

namespace findspace::exact {
namespace {

bool proven(const Real& x) { return detail::proves_zero(detail::Plan(x)); }

Real root(int128 n) { return sqrt(Real(n)); }

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

/// True, but no identity of the roots as they stand: sqrt(5 + 2 sqrt 6) = sqrt 2 + sqrt 3. The bound tells.
TEST(ZeroProof, ARootThatLiesInTheFieldOfOthers) {
  const Real x = sqrt(Real(5) + Real(2) * root(6)) - root(2) - root(3);
  EXPECT_FALSE(proven(x));
  EXPECT_EQ(x.sign(), 0);
}

/// A point turned by the angle that puts it onto a circle lies on it; the point and the radius being made of roots.
TEST(ZeroProof, TurnedPointsLieWhereTheyWereTurnedTo) {
  std::mt19937 random(5);
  const auto number = [&] { return Real(std::uniform_int_distribution<int>(1, 1 << 20)(random)); };
  stage_counts() = {};
  for (int trial = 0; trial < 20; ++trial) {
    const Real x = number() + sqrt(number()), y = number() - sqrt(number()), level = number() / Real(3);
    for (const Turn& t : turns_where(x, y, level)) {
      const Real off = x * t.cos + y * t.sin - level, unit = t.cos * t.cos + t.sin * t.sin - 1;
      EXPECT_EQ(off.sign(), 0);
      EXPECT_EQ(unit.sign(), 0);
      EXPECT_EQ((off + Real::ratio(1, int128(1) << 100)).sign(), 1);
    }
  }
  EXPECT_GT(stage_counts().zero_identity, 20u);
}

/// Random expressions, of which many are 0: what is proven is 0 by the bound, too, and what is not 0 is never proven.
TEST(ZeroProof, NeverOfWhatIsNotZero) {
  std::mt19937 random(11);
  const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  int zeros = 0, others = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::vector<Real> made{Real(pick(4) + 1), root(pick(3) + 2), root(pick(5) + 5)};
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

}  // namespace
}  // namespace findspace::exact
