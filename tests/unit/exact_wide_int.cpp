// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Fixed-width integers against GMP, on random values of random lengths and on the ends of the range.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "exact/number/wide_int.h"

namespace findspace::exact {
namespace exact_wide_int {

template <int N>
mpz_class big(const WideInt<N>& x) {
  const WideInt<N> m = x.magnitude();
  mpz_class z;
  mpz_import(z.get_mpz_t(), N, -1, sizeof(std::uint64_t), 0, 0, m.limb);
  return x.negative() ? mpz_class(-z) : z;
}
mpz_class big(int128 x) { return big(Int256(x)); }

std::vector<int128> samples() {
  std::mt19937_64 random(1);
  std::vector<int128> values{0, 1, -1, ~(int128{1} << 127), int128{1} << 127, int128{1} << 64, -(int128{1} << 64)};
  for (int i = 0; i < 60; ++i) {
    const auto bits = static_cast<int128>(static_cast<uint128>(random()) << 64 | random());
    values.push_back(bits >> (random() % 127));
  }
  return values;
}

TEST(WideInt, ZeroAndSigns) {
  EXPECT_EQ(Int256().sign(), 0);
  EXPECT_EQ(Int256(5).sign(), 1);
  EXPECT_EQ(Int256(-5).sign(), -1);
  EXPECT_EQ((Int512(-5) + Int512(5)).sign(), 0);
  EXPECT_EQ(Int256().to_double(), 0.0);
  EXPECT_EQ(Int256(-1).to_double(), -1.0);
  EXPECT_EQ(Int512(-1).bit_length(), 1);
}

TEST(WideInt, AgreesWithGmp) {
  const std::vector<int128> values = samples();
  for (int128 a : values) {
    for (int128 b : values) {
      const Int256 product = multiply(a, b);
      ASSERT_TRUE(big(product) == big(a) * big(b));
      ASSERT_TRUE(big(Int256(a) + Int256(b)) == big(a) + big(b));
      ASSERT_TRUE(big(Int256(a) - Int256(b)) == big(a) - big(b));
      ASSERT_TRUE((Int256(a) <=> Int256(b)) == (a <=> b));
      ASSERT_TRUE((Int256(a) == Int256(b)) == (a == b));
      ASSERT_TRUE(product.sign() == sgn(big(product)));
      const Int512 cube = multiply(product, a), square = multiply(product, product);
      ASSERT_TRUE(big(cube) == big(product) * big(a));
      ASSERT_TRUE(big(square) == big(product) * big(product));
      ASSERT_TRUE(big(multiply(product, Int256(b))) == big(product) * big(b));
      ASSERT_TRUE(big(-cube) == -big(cube));
      ASSERT_TRUE((cmp(big(square), big(cube)) < 0) == (square < cube));
      ASSERT_TRUE(big(Int512(product)) == big(product));
    }
  }
}

TEST(WideInt, DoublesAreClose) {
  const std::vector<int128> values = samples();
  for (int128 a : values) {
    for (int128 b : values) {
      const Int256 x = multiply(a, b);
      const Int512 y = multiply(x, x) - Int512(x);
      for (const auto& [value, exact] : {std::pair(x.to_double(), big(x)), std::pair(y.to_double(), big(y))}) {
        const mpz_class error = abs(mpz_class(value) - exact) << 52;
        ASSERT_TRUE(error <= abs(exact));
      }
    }
  }
}

}  // namespace exact_wide_int
}  // namespace findspace::exact
