// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Arrays of doubles on the grid in one pass are what Grid::nearest makes of each number.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "findspace/error.h"
#include "plane/contour/grid_points.h"

namespace plane_grid_points {

using namespace findspace;
using exact::Real;
using plane::Grid;
using plane::GridPoint;
using plane::RoundingLog;

/// The same by exact decimals.
GridPoint exactly(const Grid& grid, const std::array<double, 2>& p, RoundingLog& log) {
  return grid.nearest(plane::decimal_of(p[0]), plane::decimal_of(p[1]), log);
}

void compare_all(const Grid& grid, const std::vector<std::array<double, 2>>& points) {
  RoundingLog fast, exact;
  const plane::Contour made = plane::grid_contour(grid, points, "ring", fast);
  ASSERT_EQ(made.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_EQ(made[k].start, exactly(grid, points[k], exact)) << points[k][0] << " " << points[k][1];
  EXPECT_EQ(fast.points, exact.points);
  EXPECT_NEAR(fast.largest, exact.largest, 1e-4);  // in steps, of doubles of up to 1e11 steps: eight roundings
}

TEST(GridPoints, OfRandomDecimalsAndDoubles) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(-1e5, 1e5);
  for (const char* step : {"0.000001", "0.01", "1", "0.25", "3", "0.7"}) {
    std::vector<std::array<double, 2>> points;
    for (int k = 0; k < 400; ++k) {
      const double x = any(random), y = any(random);
      points.push_back({x, y});                                                       // off most grids
      points.push_back({std::round(x * 1e4) / 1e4, std::round(y * 100) / 100});       // decimals
      points.push_back({std::nextafter(std::round(x), 1e9), std::round(y * 4) / 4});  // an ulp off
    }
    compare_all(Grid(Real::parse_decimal(step)), points);
  }
}

TEST(GridPoints, AtTheLimits) {
  const Grid grid;  // 2^40 steps of a millionth
  compare_all(grid, {{999999.999999, -999999.999999},
                     {1000000, -1000000},
                     {1000000.000001, 1099511.627776},
                     {-1099511.627776, 0.0},
                     {-0.0, 5e-7},
                     {4.9e-7, -5e-7},
                     {1e-300, -1e-300}});
}

TEST(GridPoints, MistakesNameTheVertex) {
  RoundingLog log;
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e9, -1e300}) {
    const std::vector<std::array<double, 2>> points{{0, 0}, {1, bad}};
    try {
      plane::grid_contour(Grid(), points, "hole 2", log);
      ADD_FAILURE() << bad;
    } catch (const Error& e) {
      EXPECT_EQ(e.place(), "hole 2, vertex 1");
    }
  }
}

}  // namespace plane_grid_points
