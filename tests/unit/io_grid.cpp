// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The way of decimals onto the grid: to the nearest point, ties away from zero, with the move decided; its limit.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "io/text/units.h"

namespace findspace::io {
namespace io_grid {

using exact::Real;

std::int64_t on(const char* step, const char* text, double* moved = nullptr) {
  double by = 0;
  const std::int64_t at = Grid(Real::parse_decimal(step)).nearest(Real::parse_decimal(text), by);
  if (moved != nullptr) *moved = by;
  return at;
}

TEST(Grid, RoundsHalfAwayFromZero) {
  EXPECT_EQ(on("1", "2.5"), 3);
  EXPECT_EQ(on("1", "-2.5"), -3);
  EXPECT_EQ(on("1", "2.4999999999999999999999999999"), 2);
  EXPECT_EQ(on("0.001", "0.0005"), 1);
  EXPECT_EQ(on("100", "1234"), 12);
  EXPECT_EQ(on("0.000001", "1e-300"), 0);
}

TEST(Grid, TellsTheMove) {
  double moved = 0;
  EXPECT_EQ(on("0.001", "1.1", &moved), 1100);
  EXPECT_EQ(moved, 0);
  EXPECT_EQ(on("0.001", "-0.12345", &moved), -123);
  EXPECT_DOUBLE_EQ(moved, 0.45);
}

TEST(Grid, RefusesBeyondItsRange) {
  EXPECT_EQ(on("1", "1099511627776"), Grid::kLimit);
  EXPECT_EQ(on("1", "-1099511627776"), -Grid::kLimit);
  // As doubles these are the limit itself.
  EXPECT_THROW(on("1", "1099511627776.00001"), Error);
  EXPECT_THROW(on("1", "-1099511627776.00001"), Error);
  EXPECT_THROW(on("0.001", "1099511628"), Error);
}

}  // namespace io_grid
}  // namespace findspace::io
