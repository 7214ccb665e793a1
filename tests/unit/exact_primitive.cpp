// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "exact/number/primitive.h"
#include "exact/planar/geometry.h"

namespace findspace::exact {
namespace exact_primitive {

void expect_as_one_by_one(std::vector<Normal> all) {
  std::vector<Normal> found = all;
  make_primitive(found);
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::int64_t a = all[k].a, b = all[k].b;
    make_primitive(a, b);
    ASSERT_EQ(found[k].a, a) << all[k].a << " " << all[k].b;
    ASSERT_EQ(found[k].b, b) << all[k].a << " " << all[k].b;
  }
}

TEST(Primitive, SmallVectors) {
  std::vector<Normal> all;
  for (std::int64_t a = -60; a <= 60; ++a)
    for (std::int64_t b = -60; b <= 60; ++b)
      if (a != 0 || b != 0) all.push_back({a, b});
  expect_as_one_by_one(all);
}

TEST(Primitive, RandomVectorsOfAllSizes) {
  std::mt19937_64 rng(1);
  std::vector<Normal> all;
  while (all.size() < 100'000) {
    auto number = [&] { return std::int64_t(rng() >> (14 + rng() % 48)) * (rng() % 2 ? 1 : -1); };
    const Normal n{number(), number()};
    if (n.a != 0 || n.b != 0) all.push_back(n);
  }
  expect_as_one_by_one(all);
}

TEST(Primitive, LongAndAwkwardVectors) {
  constexpr std::int64_t kMost = std::int64_t(1) << 50;
  std::vector<Normal> all{{kMost, 1}, {1, -kMost}, {kMost, kMost - 1}, {-kMost, -kMost}, {kMost, 0}, {0, -kMost}};
  for (std::int64_t d : {3, 7, 1'000'003}) {
    all.push_back({kMost / d * d, d});
    all.push_back({kMost / 2 / d * d, -2 * d});
  }
  for (std::int64_t a = 1, b = 1; b < kMost / 6; b += a, a = b - a) {  // Fibonacci numbers need the most steps
    all.push_back({a, b});
    all.push_back({6 * b, -6 * a});
  }
  for (std::int64_t b = 1; b < kMost / 5; b *= 3) {
    all.push_back({2 * b + 1, 2 * b});
    all.push_back({5 * b + 1, 2 * b});
  }
  expect_as_one_by_one(all);
}

TEST(Primitive, VectorsThatFloatsJustHold) {
  constexpr std::int64_t kMost = std::int64_t(1) << 22;
  std::mt19937_64 rng(2);
  std::vector<Normal> all{{kMost, 1},      {-1, kMost},        {kMost, kMost - 1}, {kMost - 1, -kMost}, {-kMost, 0},
                          {0, kMost},      {-kMost, -kMost},   {kMost, 3},         {kMost - 1, 2},      {2, 1 - kMost},
                          {kMost / 2, -2}, {kMost, kMost / 2}, {2796203, 1398101}};
  for (std::int64_t a = 1, b = 1; b <= kMost; b += a, a = b - a) all.push_back({-a, b});
  while (all.size() < 100'000) {
    const std::int64_t d = 1 + std::int64_t(rng() % 9), most = kMost / d;
    auto number = [&] { return d * (std::int64_t(rng() % std::uint64_t(2 * most + 1)) - most); };
    const Normal n{number(), number()};
    if (n.a != 0 || n.b != 0) all.push_back(n);
  }
  expect_as_one_by_one(all);
  for (std::size_t count = 1; count <= 17; ++count)
    expect_as_one_by_one({all.begin(), all.begin() + std::ptrdiff_t(count)});
}

TEST(Primitive, Nothing) { expect_as_one_by_one({}); }

}  // namespace exact_primitive
}  // namespace findspace::exact
