// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Decimals: what is refused, what is exact, and the way onto the grid.
#include <gtest/gtest.h>

#include "exact/decimal.h"
#include "findspace/error.h"

namespace findspace::exact {
namespace {

ErrorCode refusal(std::string_view text, int grid_exponent = 0) {
  try {
    to_grid(text, grid_exponent);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::kUsage;
}

TEST(Decimal, RefusesWhatIsNone) {
  for (const char* text : {"",   "-",  "+",    ".",   "-.",  "e5",        ".e5", "1e",  "1e+", "1e1.5", "1.2.3",
                           " 1", "1 ", "0x10", "nan", "inf", "-Infinity", "1,5", "--1", "1f",  "1e5x"}) {
    EXPECT_EQ(refusal(text), ErrorCode::kSyntax) << text;
  }
  EXPECT_EQ(refusal(std::string_view("1\0", 2)), ErrorCode::kSyntax);
}

TEST(Decimal, ReadsExactly) {
  EXPECT_TRUE(Real::parse_decimal("1.1") == Real::ratio(11, 10));
  EXPECT_TRUE(Real::parse_decimal("-2.5e-3") == Real::ratio(-1, 400));
  EXPECT_TRUE(Real::parse_decimal("+.5") == Real::ratio(1, 2));
  EXPECT_TRUE(Real::parse_decimal("5.") == Real(5));
  EXPECT_TRUE(Real::parse_decimal("-0.000e77777777777777777777").integer() == int128{0});
  EXPECT_TRUE(Real::parse_decimal("00012.3400E2") == Real(1234));
  EXPECT_TRUE(Real::parse_decimal("123456789012345678901234567890.5") * Real(2) ==
              Real::parse_decimal("246913578024691357802469135781"));
  EXPECT_THROW(Real::parse_decimal("1e5000"), Error);
  EXPECT_THROW(Real::parse_decimal("1e-99999999999999999999999"), Error);
}

TEST(Decimal, GridRoundsHalfAwayFromZero) {
  EXPECT_EQ(to_grid("2.5", 0).value, 3);
  EXPECT_EQ(to_grid("-2.5", 0).value, -3);
  EXPECT_EQ(to_grid("2.4999999999999999999999999999", 0).value, 2);
  EXPECT_EQ(to_grid("0.0005", -3).value, 1);
  EXPECT_EQ(to_grid("1234", 2).value, 12);
}

TEST(Decimal, GridKeepsTheError) {
  const OnGrid exact = to_grid("1.1", -3);
  EXPECT_EQ(exact.value, 1100);
  EXPECT_EQ(exact.remainder.sign(), 0);
  const OnGrid rounded = to_grid("-0.12345", -3);
  EXPECT_EQ(rounded.value, -123);
  EXPECT_TRUE(rounded.remainder == Real::ratio(-45, 100));
  const OnGrid inch = to_grid("1", Real::ratio(254, 10));
  EXPECT_EQ(inch.value, 0);
  EXPECT_TRUE(inch.remainder == Real::ratio(10, 254));
  EXPECT_THROW(to_grid("1", Real(0)), Error);
  EXPECT_THROW(to_grid("1", sqrt(Real(2))), Error);
}

TEST(Decimal, GridRefusesBeyondItsRange) {
  EXPECT_EQ(to_grid("1099511627776", 0).value, kMaxGridCoordinate);
  EXPECT_EQ(to_grid("-1099511627776.49", 0).value, -kMaxGridCoordinate);
  EXPECT_EQ(refusal("1099511627776.5"), ErrorCode::kOutOfRange);
  EXPECT_EQ(refusal("1099511627777"), ErrorCode::kOutOfRange);
  EXPECT_EQ(refusal("1099511628", -3), ErrorCode::kOutOfRange);
  EXPECT_EQ(refusal("1e300", -300), ErrorCode::kOutOfRange);
  EXPECT_EQ(refusal("1e4000", -4000), ErrorCode::kOutOfRange);
  EXPECT_EQ(to_grid("1e-300", -6).value, 0);
  EXPECT_EQ(to_grid("1e-300", -6).remainder.sign(), 1);
}

}  // namespace
}  // namespace findspace::exact
