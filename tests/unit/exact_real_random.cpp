// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Random expressions, each beside its value in plain 6000-bit MPFR: signs, enclosures and doubles agree. Half of the
// expressions are identities (exact zeros that only algebra knows), some of them moved by a hair.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <memory>
#include <random>

#include "exact/number/expression_sign.h"
#include "exact/number/real.h"
#include "exact/number/stages.h"

namespace findspace::exact {
namespace exact_real_random {

constexpr mpfr_prec_t kBits = 6000;
constexpr mpfr_exp_t kZeroExponent = -3500;  // below: 0 (checked against the separation bound of each expression)

/// A Real with its approximation by other means.
struct Twin {
  Real exact;
  std::shared_ptr<__mpfr_struct> wide = make();

  static std::shared_ptr<__mpfr_struct> make() {
    auto* x = new __mpfr_struct;
    mpfr_init2(x, kBits);
    mpfr_set_zero(x, 1);
    return {x, [](__mpfr_struct* y) {
              mpfr_clear(y);
              delete y;
            }};
  }
  static Twin integer(std::int64_t value) {
    Twin t{Real(value)};
    mpfr_set_si(t.wide.get(), value, MPFR_RNDN);
    return t;
  }
  int sign() const {
    return mpfr_zero_p(wide.get()) || mpfr_get_exp(wide.get()) < kZeroExponent ? 0 : mpfr_sgn(wide.get());
  }
};

using MpfrOperation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
Twin apply(const Twin& a, const Twin& b, Real exact, MpfrOperation op) {
  Twin t{std::move(exact)};
  op(t.wide.get(), a.wide.get(), b.wide.get(), MPFR_RNDN);
  return t;
}
Twin operator+(const Twin& a, const Twin& b) { return apply(a, b, a.exact + b.exact, mpfr_add); }
Twin operator-(const Twin& a, const Twin& b) { return apply(a, b, a.exact - b.exact, mpfr_sub); }
Twin operator*(const Twin& a, const Twin& b) { return apply(a, b, a.exact * b.exact, mpfr_mul); }
Twin operator/(const Twin& a, const Twin& b) { return apply(a, b, a.exact / b.exact, mpfr_div); }
Twin root(const Twin& a) {
  Twin t{sqrt(a.exact)};
  mpfr_sqrt(t.wide.get(), a.wide.get(), MPFR_RNDN);
  if (a.sign() == 0) mpfr_set_zero(t.wide.get(), 1);
  return t;
}

class Expressions {
 public:
  explicit Expressions(unsigned seed) : random_(seed) {}

  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  Twin leaf() {
    const int bits[] = {2, 4, 10, 30};
    const int size = bits[pick(4)];
    const auto value = static_cast<std::int64_t>(random_() % (std::uint64_t{1} << size)) - (1 << (size - 1));
    return Twin::integer(value);
  }

  Twin tree(int depth, int roots) {
    if (depth == 0) return leaf();
    const Twin a = tree(depth - 1, roots / 2);
    const int operation = pick(roots > 0 ? 6 : 4);
    if (operation >= 4) return root(a.sign() < 0 ? Twin::integer(0) - a : a);
    const Twin b = tree(pick(depth), roots - roots / 2);
    if (operation == 0) return a + b;
    if (operation == 1) return a - b;
    if (operation == 2 || b.sign() == 0) return a * b;
    return a / b;
  }

  /// An expression that is 0, in a shape that does not show it.
  Twin zero(const Twin& x, const Twin& y) {
    const Twin two = Twin::integer(2);
    switch (pick(5)) {
      case 0:
        return (x + y) * (x + y) - x * x - two * x * y - y * y;
      case 1:
        return (x + y) * (x - y) - (x * x - y * y);
      case 2:
        return root(x * x) - (x.sign() < 0 ? Twin::integer(0) - x : x);
      case 3:
        return y.sign() == 0 ? x - x : x / y * y - x;
      default: {
        const Twin p = x * x + two, q = y * y + Twin::integer(1);
        return root(p) + root(q) - root(p + q + two * root(p * q));
      }
    }
  }

 private:
  std::mt19937_64 random_;
};

void check(const Twin& t) {
  const int expected = t.sign();
  ASSERT_EQ(t.exact.sign(), expected);
  const Interval enclosure = t.exact.interval();
  if (expected == 0) {
    ASSERT_LE(enclosure.lo, 0);
    ASSERT_GE(enclosure.hi, 0);
    ASSERT_EQ(t.exact.to_double(), 0);
    return;
  }
  const Twin rounded;  // to half the bits, as a value that is an end of its enclosure may be off by rounding errors
  mpfr_set_prec(rounded.wide.get(), kBits / 2);
  mpfr_set(rounded.wide.get(), t.wide.get(), MPFR_RNDN);
  ASSERT_LE(mpfr_cmp_d(rounded.wide.get(), enclosure.hi), 0);
  ASSERT_GE(mpfr_cmp_d(rounded.wide.get(), enclosure.lo), 0);
  const double nearest = mpfr_get_d(t.wide.get(), MPFR_RNDN);
  ASSERT_LE(std::abs(t.exact.to_double() - nearest), std::abs(nearest) * 0x1p-52);
}

TEST(RealRandom, AgreesWithPlainMpfr) {
  stage_counts() = {};
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Expressions make(seed);
    const Twin x = make.tree(3, 2), y = make.tree(2, 1);
    check(x);
    check(y);
    const Twin zero = make.zero(x, y);
    if (detail::separation_bits(zero.exact) > 3400) continue;  // not decided by the plain evaluation
    check(zero);
    check(zero * make.leaf() + Twin::integer(1) / Twin::integer(int64_t{1} << 62));
    check(zero - Twin::integer(1) / (Twin::integer(int64_t{1} << 62) * Twin::integer(int64_t{1} << 62)));
  }
  EXPECT_GT(stage_counts().filter, 100u);
  EXPECT_GT(stage_counts().fixed, 100u);
  EXPECT_GT(stage_counts().bigfloat, 100u);
  EXPECT_GT(stage_counts().zero_bound, 100u);
}

}  // namespace exact_real_random
}  // namespace findspace::exact
