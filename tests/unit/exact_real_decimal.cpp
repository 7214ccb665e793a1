// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Decimals: what is refused, and what is exact.
#include <gtest/gtest.h>

#include "exact/number/decimal.h"
#include "findspace/error.h"

namespace findspace::exact {
namespace exact_real_decimal {

ErrorCode refusal(std::string_view text) {
  try {
    Real::parse_decimal(text);
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

TEST(Decimal, GridIntegersAreTheNumbersOfSteps) {
  const Real step = Real::ratio(1, 1000);
  for (const char* text : {"0", "-0.0e7", "1.25", "-1.250000e+00", "+1.25e1", "125e-2", "12.345e2", "1e9", ".5E-2",
                           "5.e0", "1234567890123.456e-4", "99999999999999999e-17", "0.001e00"}) {
    const auto steps = grid_integer(text, step);
    const auto wanted = (Real::parse_decimal(text) / step).integer();
    ASSERT_EQ(steps.has_value(), wanted.has_value()) << text;
    if (steps) EXPECT_TRUE(int128{*steps} == *wanted) << text;
  }
  for (const char* text : {"", ".", "e5", "1e", "1e+", "1e 5", "1e1.5", "1e5x", "1.2.3", "1,5", "0.0001", "1e10",
                           "1e99", "1e-99", "1e100", "123456789012345678", "123456789012345678e-9", "1.2e-3"}) {
    EXPECT_FALSE(grid_integer(text, step)) << text;
  }
}

}  // namespace exact_real_decimal
}  // namespace findspace::exact
