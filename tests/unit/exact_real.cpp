// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Real: degenerate values first, then identities that are exactly 0, near misses, geometry, and which stage decided.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "exact/number/real.h"
#include "exact/number/stages.h"
#include "findspace/error.h"

namespace findspace::exact {
namespace exact_real {

Real root(int128 n) { return sqrt(Real(n)); }

constexpr std::int64_t kBig = std::int64_t{1} << 40;

TEST(Real, DefaultIsZero) {
  const Real zero;
  EXPECT_EQ(zero.sign(), 0);
  EXPECT_EQ(zero.to_double(), 0.0);
  EXPECT_EQ(zero.text(), "0");
  EXPECT_TRUE(zero.is_rational());
  EXPECT_EQ(zero.interval().lo, 0.0);
  EXPECT_EQ(zero.interval().hi, 0.0);
}

TEST(Real, IntegersAtTheEndOf128BitsSpillIntoBigOnes) {
  const int128 most = ~(int128{1} << 127), least = int128{1} << 127;
  EXPECT_TRUE((Real(most) + 1 - 1).integer() == most);
  EXPECT_TRUE((Real(least) - 1 + 1) == Real(least));
  EXPECT_TRUE(-Real(least) == Real(most) + 1);
  EXPECT_FALSE((-Real(least)).integer());
  EXPECT_TRUE(Real(most) * Real(most) / Real(most) == Real(most));
  EXPECT_TRUE((Real(least) * Real(least)).sign() > 0);
  EXPECT_TRUE(Real(least) * Real(-1) + Real(least) == Real(0));
  EXPECT_EQ(Real(least).text(), "-170141183460469231731687303715884105728");
}

TEST(Real, SmallRationalsSpillIntoBigOnesAndComeBack) {
  const Real third = Real::ratio(1, 3), fine = Real::ratio(1, (int128{1} << 62) - 57);
  const Real sum = third + fine;
  EXPECT_TRUE(sum.is_rational());
  EXPECT_TRUE(sum - fine == third);
  EXPECT_EQ((sum - third).to_double(), fine.to_double());
  EXPECT_TRUE(sum / sum == Real(1));
  EXPECT_EQ((sum - fine - third).sign(), 0);
  EXPECT_TRUE((fine * fine / fine) == fine);
  EXPECT_TRUE(Real(7) / Real(-14) == Real::ratio(-1, 2));
  EXPECT_TRUE(Real(0) / Real(-14) == Real(0));
  EXPECT_TRUE(Real::ratio(-7, 3).interval().lo <= -7.0 / 3 && Real::ratio(-7, 3).interval().hi >= -7.0 / 3);
  EXPECT_EQ(Real::ratio(-7, 3).to_double(), -7.0 / 3);
  EXPECT_EQ(Real::ratio(5, 2).text(), "2.5");
}

TEST(Real, RationalsReduce) {
  EXPECT_TRUE(Real::ratio(6, -4) == Real::ratio(-3, 2));
  EXPECT_TRUE((Real::ratio(1, 3) + Real::ratio(2, 3)).integer() == int128{1});
  EXPECT_TRUE(Real(7) / Real(2) * Real(2) == Real(7));
  EXPECT_TRUE((Real(7) / Real(2)).is_rational());
  EXPECT_THROW(Real::ratio(1, 0), Error);
  EXPECT_THROW(Real(1) / Real(0), Error);
  EXPECT_THROW(Real(1) / (root(2) * root(3) - root(6)), Error);
  EXPECT_THROW(sqrt(Real(-1)), Error);
}

TEST(Real, FromDoubleIsExact) {
  EXPECT_TRUE(Real::from_double(0.5) == Real::ratio(1, 2));
  EXPECT_FALSE(Real::from_double(0.1) == Real::ratio(1, 10));
  for (double d : {0.0, -0.0, 1.0, -3.25, 0.1, 1e300, 5e-324, -1.7976931348623157e308}) {
    EXPECT_EQ(Real::from_double(d).to_double(), d);
  }
  EXPECT_THROW(Real::from_double(NAN), Error);
  EXPECT_THROW(Real::from_double(-INFINITY), Error);
}

TEST(Real, DoublesOfFractionsAreTheNearest) {
  std::mt19937_64 rng(11);
  const auto number = [&](int bits) {
    Real out = 1;
    for (; bits > 0; bits -= 48) out *= Real(std::int64_t(rng() >> (64 - std::min(bits, 48))) | 1);
    return out;
  };
  for (const int above : {3, 20, 50, 64, 100, 130, 300}) {
    for (const int below : {2, 20, 50, 63, 64, 100, 300}) {
      for (int k = 0; k < 10; ++k) {
        const Real x = number(above) / number(below) * Real(k % 2 == 0 ? 1 : -1);
        const double d = x.to_double();
        const Real off = abs(x - Real::from_double(d));
        for (const double end : {-INFINITY, INFINITY})
          EXPECT_TRUE(off <= abs(x - Real::from_double(std::nextafter(d, end)))) << above << " " << below;
      }
    }
  }
  // Half-way between two doubles, and nearly so.
  const int128 even = int128{1} << 52, much = (int128{1} << 40) + 15;
  for (const int sign : {-1, 1}) {
    EXPECT_EQ(Real::ratio(sign * (2 * even + 1), 2).to_double(), sign * 0x1p52);
    EXPECT_EQ(Real::ratio(sign * (2 * even + 3), 2).to_double(), sign * (0x1p52 + 2));
    EXPECT_EQ(Real::ratio(sign * ((2 * even + 1) * much + 1), 2 * much).to_double(), sign * (0x1p52 + 1));
    EXPECT_EQ(Real::ratio(sign * ((2 * even + 1) * much - 1), 2 * much).to_double(), sign * 0x1p52);
    EXPECT_EQ((Real::ratio(sign * (2 * even + 1), 2) / Real(kBig) / Real(kBig)).to_double(), sign * 0x1p-28);
  }
}

TEST(Real, RootsOfSquaresAreRational) {
  EXPECT_TRUE(root(144).integer() == int128{12});
  EXPECT_TRUE(sqrt(Real::ratio(9, 16)) == Real::ratio(3, 4));
  EXPECT_TRUE(sqrt(Real::ratio(1, 2)) * root(2) == Real(1));
  EXPECT_TRUE(sqrt(Real(0)).sign() == 0);
  EXPECT_TRUE(sqrt(Real(3) + Real(2) * root(2)) == Real(1) + root(2));
  EXPECT_TRUE(sqrt(Real(3) + Real(2) * root(2)).is_closed());
  EXPECT_TRUE(sqrt(Real(3) - Real(2) * root(2)) == root(2) - Real(1));
}

TEST(Real, OneQuadraticFieldStaysClosed) {
  stage_counts() = {};
  const Real x = (Real(3) + Real(5) * root(7)) / (Real(2) - root(7));
  EXPECT_TRUE(x.is_closed());
  EXPECT_TRUE(x * (Real(2) - root(7)) == Real(3) + Real(5) * root(7));
  EXPECT_TRUE(root(8) - root(2) == root(2));
  EXPECT_TRUE(root(12 * 169 * 10007) * Real(1) == Real(26) * root(3 * 10007));
  EXPECT_TRUE(root(6 * 121) - Real(11) * root(6) == Real(0));
  EXPECT_EQ(stage_counts().bigfloat, 0u);
  EXPECT_EQ(stage_counts().zero_bound, 0u);
}

TEST(Real, QuadraticSignUnderCancellation) {
  // Convergents of sqrt 2: p - q sqrt 2 is about 1/(2q), here near 2^-63 with parts near 2^62.
  Real p = 1, q = 1;
  for (int i = 0; i < 49; ++i) {
    const Real next = p + Real(2) * q;
    q = p + q;
    p = next;
    stage_counts() = {};
    const Real x = p - q * root(2);
    EXPECT_EQ(x.sign(), i % 2 == 0 ? 1 : -1);
    EXPECT_NEAR(x.to_double() * (p + q * root(2)).to_double(), i % 2 == 0 ? 1.0 : -1.0, 1e-15);
    if (i > 22) {
      EXPECT_EQ(stage_counts().quadratic, 1u);
    }
    EXPECT_EQ(stage_counts().bigfloat, 0u);
  }
}

TEST(Real, IdentitiesThatAreZero) {
  EXPECT_EQ((root(2) + root(3) - sqrt(Real(5) + Real(2) * root(6))).sign(), 0);
  EXPECT_EQ((root(2) * root(3) - root(6)).sign(), 0);
  EXPECT_EQ((Real(1) / (root(3) - root(2)) - root(3) - root(2)).sign(), 0);
  const Real nested = sqrt(Real(2) + sqrt(Real(2) + root(2)));
  EXPECT_EQ((nested * nested - Real(2) - sqrt(Real(2) + root(2))).sign(), 0);
  // cos(pi/16) twice: the half-angle formula against the product form sqrt(2 - sqrt(2)) * sqrt(2 + sqrt 2) = sqrt 2
  EXPECT_EQ((sqrt(Real(2) - root(2)) * sqrt(Real(2) + root(2)) - root(2)).sign(), 0);
  const Real a = root(5) + root(7) + root(11);
  EXPECT_EQ((a * a - Real(23) - Real(2) * (root(35) + root(55) + root(77))).sign(), 0);
  EXPECT_EQ((a * a - Real(24) - Real(2) * (root(35) + root(55) + root(77))).sign(), -1);
}

TEST(Real, StagesThatDecide) {
  const Real sum = root(2) + root(3), one_root = sqrt(Real(5) + Real(2) * root(6));
  stage_counts() = {};
  EXPECT_EQ(sum.sign(), 1);
  EXPECT_EQ(stage_counts().filter, 1u);
  EXPECT_EQ((sum - one_root).sign(), 0);
  EXPECT_EQ(stage_counts().zero_bound, 1u);
  const Real tiny = Real::parse_decimal("1e-30");
  EXPECT_EQ((sum + tiny - one_root).sign(), 1);
  EXPECT_EQ((sum - tiny - one_root).sign(), -1);
  EXPECT_EQ(stage_counts().bigfloat, 2u);
  EXPECT_EQ(stage_counts().zero_bound, 1u);
  EXPECT_EQ(Real(5).sign(), 1);
  EXPECT_EQ(Real::ratio(-1, 3).sign(), -1);
  EXPECT_EQ(stage_counts().fixed, 2u);
}

TEST(Real, NearZeroIsNotZero) {
  for (const char* text : {"1e-60", "1e-200", "-1e-1000"}) {
    const Real tiny = Real::parse_decimal(text);
    const Real x = root(2) + root(3) + tiny - sqrt(Real(5) + Real(2) * root(6));
    EXPECT_EQ(x.sign(), tiny.sign()) << text;
    EXPECT_EQ(x.to_double(), tiny.to_double()) << text;
  }
  EXPECT_EQ((root(2) + root(3) - sqrt(Real(5) + Real(2) * root(6))).to_double(), 0.0);
}

TEST(Real, ConvergentOfASumOfRoots) {
  // sqrt(n) + sqrt(n+2) against 2 sqrt(n+1) at n = 2^80: the difference is about n^(-3/2)/4 = 2^-122.
  const int128 n = int128{1} << 80;
  const Real x = root(n - 1) + root(n + 1) - Real(2) * sqrt(Real(n));
  EXPECT_EQ(x.sign(), -1);
  EXPECT_NEAR(x.to_double() * 0x1p122, -1.0, 1e-12);
}

TEST(Real, LineMeetsCircleExactly) {
  // The line through (x0, y0) with direction (a, b) and the circle about (cx, cy) with radius rho, 2^40 large.
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(-kBig, kBig), small(-1000, 1000);
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    const Real x0 = coordinate(random), y0 = coordinate(random), a = coordinate(random), b = small(random);
    const Real cx = coordinate(random), cy = coordinate(random), rho = Real::ratio(3 * kBig, 7);
    const Real fx = x0 - cx, fy = y0 - cy;
    const Real aa = a * a + b * b, half_b = a * fx + b * fy, c = fx * fx + fy * fy - rho * rho;
    const Real disc = half_b * half_b - aa * c;
    if (disc.sign() < 0) continue;
    ++met;
    const Real t = (-half_b + sqrt(disc)) / aa;
    const Real x = x0 + t * a, y = y0 + t * b;
    EXPECT_EQ(((x - cx) * (x - cx) + (y - cy) * (y - cy) - rho * rho).sign(), 0);
    EXPECT_EQ(((x - cx) * (x - cx) + (y - cy) * (y - cy) - rho * rho + Real::parse_decimal("1e-40")).sign(), 1);
    EXPECT_TRUE(x.is_closed());
  }
  EXPECT_GT(met, 20);
}

/// Offset lines a x + b y = c + lambda sqrt(a^2 + b^2) of two directions meet in Q(sqrt n, sqrt m); a third passes
/// through the same point by construction.
TEST(Real, ThreeOffsetLinesThroughOnePoint) {
  const Real n1 = root(int128{3} * 3 + int128{5} * 5), n2 = root(int128{kBig - 1} * (kBig - 1) + 49);
  const Real a1 = 3, b1 = 5, c1 = Real(kBig - 5) + Real(10) * n1;
  const Real a2 = kBig - 1, b2 = 7, c2 = Real(17) - Real::ratio(5, 3) * n2;
  const Real det = a1 * b2 - a2 * b1;
  const Real x = (c1 * b2 - c2 * b1) / det, y = (a1 * c2 - a2 * c1) / det;
  EXPECT_EQ((a1 * x + b1 * y - c1).sign(), 0);
  EXPECT_EQ((a2 * x + b2 * y - c2).sign(), 0);
  EXPECT_EQ((a1 * x + b1 * y - c1 + Real::ratio(1, int128{1} << 100)).sign(), 1);
}

TEST(Real, TangentCircleOfAnOffsetLine) {
  // The circle about (x0, y0) with radius lambda touches the line offset by lambda: discriminant exactly 0.
  const Real a = kBig - 3, b = 12345, lambda = Real::ratio(22, 7), norm = sqrt(a * a + b * b);
  const Real x0 = 99, y0 = -kBig, c = a * x0 + b * y0 + lambda * norm;
  const Real distance = (c - a * x0 - b * y0) / norm;
  EXPECT_EQ((distance - lambda).sign(), 0);
  // The same with a radius that is itself a root.
  const Real wide = root(3) + Real(1), moved = a * x0 + b * y0 + wide * norm;
  EXPECT_EQ(((moved - a * x0 - b * y0) / norm - wide).sign(), 0);
  EXPECT_EQ(((moved - a * x0 - b * y0) / norm - wide + Real::parse_decimal("1e-50")).sign(), 1);
}

TEST(Real, CircleCircleIntersectionLiesOnBoth) {
  const Real x1 = 0, y1 = 0, r1 = kBig, x2 = kBig - 77, y2 = 4711, r2 = kBig / 3;
  const Real dx = x2 - x1, dy = y2 - y1, dd = dx * dx + dy * dy;
  const Real t = (dd + r1 * r1 - r2 * r2) / (Real(2) * dd), h = sqrt(r1 * r1 / dd - t * t);
  const Real x = x1 + t * dx - h * dy, y = y1 + t * dy + h * dx;
  EXPECT_TRUE(x.is_closed());
  EXPECT_EQ((x * x + y * y - r1 * r1).sign(), 0);
  EXPECT_EQ(((x - x2) * (x - x2) + (y - y2) * (y - y2) - r2 * r2).sign(), 0);
}

TEST(Real, ToDoubleIsAccurate) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<std::int64_t> pick(1, kBig);
  for (int i = 0; i < 300; ++i) {
    const std::int64_t a = pick(random), b = pick(random), c = pick(random);
    const Real x = root(a) + root(b) - root(c);
    // The error is a Real too: |x - d| <= 2^-52 |x|, and d is inside the enclosure.
    const double d = x.to_double();
    EXPECT_LE(compare(abs(x - Real::from_double(d)), abs(x) * Real::ratio(1, int128{1} << 52)), 0);
    EXPECT_LE(x.interval().lo, d);
    EXPECT_GE(x.interval().hi, d);
  }
}

TEST(Real, FloorAndRound) {
  EXPECT_TRUE(floor(Real::ratio(-7, 2)) == -4);
  EXPECT_TRUE(round(Real::ratio(-7, 2)) == -4);
  EXPECT_TRUE(round(Real::ratio(5, 2)) == 3);
  EXPECT_TRUE(round(Real::ratio(5, 2) - Real::parse_decimal("1e-30")) == 2);
  const Real large = root(2) * Real(int128{1} << 70);
  EXPECT_LE(compare(Real(floor(large)), large), 0);
  EXPECT_GT(compare(Real(floor(large) + 1), large), 0);
  EXPECT_THROW(floor(large * large), Error);
  EXPECT_TRUE(floor(root(2) + root(3) - sqrt(Real(5) + Real(2) * root(6))) == 0);
  EXPECT_TRUE(floor(-root(2) - root(3)) == -4);
}

TEST(Real, DeepGraphsNeitherOverflowTheStackNorHang) {
  Real x = root(2) + root(3);
  for (int i = 0; i < 300000; ++i) x = x + root(5 + i % 2);
  EXPECT_EQ(x.sign(), 1);
  EXPECT_NEAR(x.to_double(), 300000 * (std::sqrt(5.0) + std::sqrt(6.0)) / 2 + std::sqrt(2.0) + std::sqrt(3.0), 1e-6);
}

TEST(Real, ManyThreadsReadOneValue) {
  const Real x = root(2) + root(3) - sqrt(Real(5) + Real(2) * root(6));
  std::vector<std::thread> threads;
  std::vector<int> signs(4, 7);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&signs, x, t] {
      for (int i = 0; i < 100; ++i) {
        const Real copy = x;
        signs[t] = copy.sign();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(signs, std::vector<int>(4, 0));
}

}  // namespace exact_real
}  // namespace findspace::exact
