// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "distance/search/lp_bound.h"

namespace findspace::distance {
namespace distance_lp_bound {

using Column = std::array<double, 4>;

/// What a mix of rows gets of the column that is worst for it: the value is at least that.
double least_of_mix(const std::vector<Column>& columns, const Column& rows) {
  double least = 1e300;
  for (const Column& c : columns) {
    double sum = 0;
    for (std::size_t r = 0; r < 4; ++r) sum += rows[r] * c[r];
    least = std::min(least, sum);
  }
  return least;
}

TEST(LpBound, OneColumn) {
  EXPECT_EQ(lp_bound({{1, 5, 2, 0}}).value, 5);
  EXPECT_EQ(lp_bound({{0, 0, 0, 0}}).value, 0);
}

/// Distances to planes of one plane differ by rounding: whatever the tableau makes of that, the value is not too low.
TEST(LpBound, ColumnsThatAreNearlyTheSame) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 20000; ++round) {
    std::vector<Column> columns, kinds_only;
    const int kinds = 3 + round % 2;
    for (int k = 0; k < kinds; ++k) {
      Column c;
      for (double& entry : c) entry = round % 4 < 2 ? unit(random) : std::floor(3 * unit(random)) / 2;
      kinds_only.push_back(c);
      for (int copy = 0; copy < 2 + round % 3; ++copy) {
        Column other = c;
        for (double& entry : other) entry += unit(random) < 0.5 ? std::ldexp(unit(random), -28 - round % 24) : 0;
        columns.push_back(other);
      }
    }
    const LpBound bound_of_lp = lp_bound(columns);
    ASSERT_GE(bound_of_lp.value, least_of_mix(columns, bound_of_lp.rows) - 1e-14) << round;
    ASSERT_NEAR(bound_of_lp.value, lp_bound(kinds_only).value, 1e-6) << round;
  }
}

}  // namespace distance_lp_bound
}  // namespace findspace::distance
