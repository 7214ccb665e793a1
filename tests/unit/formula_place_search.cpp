// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search for the least value over places: numbers bound boxes, and exact looks are few.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "formula/explain/place_search.h"

namespace findspace::formula {
namespace formula_place_search {

using exact::Real;
using space::RealVector;
using space::Vector;

constexpr double kOff = 1e-9, kTolerance = 0x1p-3;
const std::vector<PlaceBox> kBox{{{0, 0, 0}, {64, 64, 64}}};

/// The distance from (10, 4, 1) where x is at least 20.
PlaceSeen seen_at(const Vector& p) {
  const double d = space::length(p - Vector{10, 4, 1});
  return {{d, d}, p.x - 20, p.x >= 20};
}

struct Counted {
  std::atomic<long> looks = 0, glances = 0;
  PlaceSearch search(bool open) {
    PlaceSearch out;
    out.tolerance = kTolerance;
    out.look = [this](const RealVector& p) {
      ++looks;
      return seen_at(space::rounded(p));
    };
    out.glance = [this, open](const Vector& p, const PlaceSearch::Needless&) {
      ++glances;
      PlaceSeen near = seen_at(p);
      near.value = {near.value.lo - kOff, open ? exact::kInfinity : near.value.hi + kOff};
      near.inside += kOff;
      near.belongs = near.inside > 2 * kOff;
      near.open = open;
      return near;
    };
    return out;
  }
};

TEST(PlaceSearch, NumbersBoundBoxes) {
  Counted counted;
  const PlaceFound found = find_place(counted.search(false), kBox);
  const double least = std::sqrt(100.0);
  ASSERT_TRUE(found.at);
  EXPECT_GE(found.least, least);
  EXPECT_LE(found.least, least + kTolerance);
  EXPECT_LE(found.bound, least);
  EXPECT_GE(found.bound, found.least - kTolerance - kOff);
  // `least` is the exact value of its place, not what numbers say.
  EXPECT_EQ(found.least, seen_at(space::rounded(*found.at)).value.hi);
  EXPECT_GT(counted.glances, 1000);
  EXPECT_LT(counted.looks, 100);
}

TEST(PlaceSearch, OpenNumbersAreLookedAt) {
  Counted closed, open;
  const PlaceFound one = find_place(closed.search(false), kBox), other = find_place(open.search(true), kBox);
  EXPECT_EQ(one.least, other.least);
  EXPECT_GT(open.looks, closed.looks);
}

TEST(PlaceSearch, NoPlaceBelongs) {
  PlaceSearch search;
  search.look = [](const RealVector&) { return PlaceSeen{{0, 0}, -1, false}; };
  search.glance = [](const Vector& p, const PlaceSearch::Needless&) { return PlaceSeen{{0, 0}, p.x - 100, false}; };
  const PlaceFound found = find_place(search, kBox);
  EXPECT_FALSE(found.at);
  EXPECT_EQ(found.bound, exact::kInfinity);
}

/// A value that is undefined at all places of a box is not looked for in its parts.
TEST(PlaceSearch, UndefinedEverywhere) {
  Counted counted;
  PlaceSearch search = counted.search(false);
  search.glance = [&](const Vector& /*p*/, const PlaceSearch::Needless&) {
    ++counted.glances;
    return PlaceSeen{{exact::kInfinity, exact::kInfinity}};
  };
  EXPECT_FALSE(find_place(search, kBox).at);
  EXPECT_EQ(counted.glances, 1);
  EXPECT_EQ(counted.looks, 0);
}

}  // namespace formula_place_search
}  // namespace findspace::formula
