// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <vector>

#include "planning/solid/difference_boxes.h"

namespace findspace::planning {
namespace planning_difference_boxes {

using exact::Real;
using space::Interval;
using space::IntervalBox;

IntervalBox on_x(std::optional<int> from, bool from_in, std::optional<int> to, bool to_in) {
  IntervalBox out;
  if (from) {
    out[0].from = Real(*from);
    out[0].from_in = from_in;
  }
  if (to) {
    out[0].to = Real(*to);
    out[0].to_in = to_in;
  }
  return out;
}

TEST(DifferenceBoxes, WithoutDemandsAllDifferencesArePossible) {
  const DifferenceBoxes all(3);
  EXPECT_FALSE(all.empty());
  EXPECT_FALSE(all.range(1, 2)[2].from || all.range(1, 2)[2].to);
}

TEST(DifferenceBoxes, AStrictRoundIsEmptyAndAClosedOneIsAPoint) {
  DifferenceBoxes open(2), closed(2);
  open.demand(1, 0, on_x(0, true, 2, true));
  open.demand(1, 0, on_x(2, false, std::nullopt, false));
  EXPECT_TRUE(open.empty());
  closed.demand(1, 0, on_x(0, true, 2, true));
  closed.demand(1, 0, on_x(2, true, std::nullopt, false));
  ASSERT_FALSE(closed.empty());
  const Interval k = closed.range(1, 0)[0];
  EXPECT_EQ(*k.from, Real(2));
  EXPECT_EQ(*k.to, Real(2));
  EXPECT_TRUE(k.from_in && k.to_in);
}

struct Demand {
  std::size_t i, j;
  int from, to;
  bool from_in, to_in;
  bool holds(int quarters) const {
    return (from_in ? quarters >= 4 * from : quarters > 4 * from) && (to_in ? quarters <= 4 * to : quarters < 4 * to);
  }
};

/// All differences of positions in quarters that meet the demands: of three positions with whole bounds no gap is
/// smaller.
std::vector<std::array<int, 4>> by_trial(const std::vector<Demand>& demands) {
  std::vector<std::array<int, 4>> out;
  std::array<int, 4> p{};
  for (p[1] = 0; p[1] <= 12; ++p[1])
    for (p[2] = 0; p[2] <= 12; ++p[2])
      for (p[3] = 0; p[3] <= 12; ++p[3])
        if (std::all_of(demands.begin(), demands.end(), [&](const Demand& d) { return d.holds(p[d.i] - p[d.j]); }))
          out.push_back(p);
  return out;
}

TEST(DifferenceBoxes, BoundsAreThoseOfAllPositions) {
  std::mt19937 random(3);
  const auto pick = [&](int low, int high) { return low + int(random() % unsigned(high - low + 1)); };
  int full = 0;
  for (int round = 0; round < 150; ++round) {
    std::vector<Demand> demands;
    for (std::size_t b = 1; b < 4; ++b) demands.push_back({b, 0, 0, 3, true, true});
    for (int k = 0; k < 4; ++k) {
      const auto i = std::size_t(pick(1, 3)), j = std::size_t(pick(0, 3));
      if (i == j) continue;
      const int from = pick(-2, 2);
      demands.push_back({i, j, from, from + pick(0, 2), pick(0, 1) == 1, pick(0, 1) == 1});
    }
    DifferenceBoxes boxes(4);
    for (const Demand& d : demands) boxes.demand(d.i, d.j, on_x(d.from, d.from_in, d.to, d.to_in));
    const auto all = by_trial(demands);
    ASSERT_EQ(boxes.empty(), all.empty()) << "round " << round;
    if (all.empty()) continue;
    ++full;
    for (std::size_t b = 1; b < 4; ++b) {
      const Interval k = boxes.range(b, 0)[0];
      int low = 99, high = -99;
      for (const auto& p : all) {
        low = std::min(low, p[b]);
        high = std::max(high, p[b]);
      }
      const Real from = Real(4) * *k.from, to = Real(4) * *k.to;
      EXPECT_TRUE(k.from_in ? from == Real(low) : from < Real(low) && Real(low) <= from + Real(3)) << "round " << round;
      EXPECT_TRUE(k.to_in ? to == Real(high) : to > Real(high) && Real(high) >= to - Real(3)) << "round " << round;
    }
  }
  EXPECT_GT(full, 20);
}

}  // namespace planning_difference_boxes
}  // namespace findspace::planning
