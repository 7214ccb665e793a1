// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/problem/fraction.h"

#include <findspace/error.h>

#include <algorithm>

#include "exact/number/decimal.h"

namespace findspace::packing {
namespace {

constexpr int kMostDigits = 30;
constexpr int128 kMost = int128{1} << 100;

int128 absolute(int128 a) { return a < 0 ? -a : a; }

int128 divisor(int128 a, int128 b) {
  a = absolute(a);
  while (b != 0) {
    const int128 rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

[[noreturn]] void out_of_range() { throw Error(ErrorCode::kOutOfRange, "a number has too many digits for a layout"); }

std::string digits_of(int128 value) {
  std::string text;
  for (int128 rest = absolute(value); rest != 0; rest /= 10) text += char('0' + int(rest % 10));
  if (text.empty()) text = "0";
  std::reverse(text.begin(), text.end());
  return text;
}

Fraction decimal(std::string_view text) {
  const exact::Decimal parsed = exact::Decimal::parse(text);
  int128 value = 0;
  for (const char c : parsed.digits) value = bounded_product(value, 10) + (c - '0');
  if (parsed.negative) value = -value;
  if (absolute(parsed.exponent) > kMostDigits) out_of_range();
  const int exponent = int(parsed.exponent);
  if (exponent >= 0) return Fraction(bounded_product(value, power_of_ten(exponent)), 1);
  return Fraction(value, power_of_ten(-exponent));
}

/// How many digits follow the point, or -1 where the decimal does not end within the digits allowed.
int digits_after_point(int128 denominator) {
  for (int digits = 0; digits <= kMostDigits; ++digits)
    if (power_of_ten(digits) % denominator == 0) return digits;
  return -1;
}

}  // namespace

int128 bounded_product(int128 a, int128 b) {
  int128 product = 0;
  if (__builtin_mul_overflow(a, b, &product) || absolute(product) >= kMost) out_of_range();
  return product;
}

int128 power_of_ten(int exponent) {
  int128 power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

int128 common_multiple(int128 a, int128 b) { return bounded_product(a / divisor(a, b), b); }

Fraction::Fraction(int128 numerator, int128 denominator) {
  const int128 common = divisor(numerator, absolute(denominator)) * (denominator < 0 ? -1 : 1);
  numerator_ = numerator / common;
  denominator_ = denominator / common;
  if (absolute(numerator_) >= kMost || denominator_ >= kMost) out_of_range();
}

Fraction Fraction::parse(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return decimal(text);
  const Fraction above = decimal(text.substr(0, slash)), below = decimal(text.substr(slash + 1));
  if (below.numerator_ == 0) throw Error(ErrorCode::kSyntax, "a fraction with the denominator 0");
  return Fraction(bounded_product(above.numerator_, below.denominator_),
                  bounded_product(above.denominator_, below.numerator_));
}

int128 Fraction::over(int128 multiple) const { return bounded_product(numerator_, multiple / denominator_); }

std::string Fraction::text() const {
  const std::string sign = numerator_ < 0 ? "-" : "";
  const int after = digits_after_point(denominator_);
  if (after < 0) return sign + digits_of(numerator_) + "/" + digits_of(denominator_);
  if (after == 0) return sign + digits_of(numerator_);
  std::string digits = digits_of(bounded_product(numerator_, power_of_ten(after) / denominator_));
  if (int(digits.size()) <= after) digits.insert(0, std::size_t(after + 1) - digits.size(), '0');
  return sign + digits.insert(digits.size() - std::size_t(after), ".");
}

Fraction operator+(const Fraction& a, const Fraction& b) {
  const int128 common = common_multiple(a.denominator_, b.denominator_);
  return Fraction(a.over(common) + b.over(common), common);
}

Fraction operator-(const Fraction& a, const Fraction& b) {
  const int128 common = common_multiple(a.denominator_, b.denominator_);
  return Fraction(a.over(common) - b.over(common), common);
}

std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
  const exact::Int256 left = exact::multiply(a.numerator_, b.denominator_),
                      right = exact::multiply(b.numerator_, a.denominator_);
  return left <=> right;
}

}  // namespace findspace::packing
