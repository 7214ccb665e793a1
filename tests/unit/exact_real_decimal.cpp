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

}  // namespace exact_real_decimal
}  // namespace findspace::exact
