// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Fractions of machine integers: coordinates as layouts state them, "1203.25" or "17/3". Numerator and denominator stay
// below 2^100. What does not fit is Error(kOutOfRange). Guarantee: exact. Keywords: rational number.
#pragma once

#include <compare>
#include <string>
#include <string_view>

#include "exact/number/wide_int.h"

namespace findspace::packing {

using exact::int128;

class Fraction {
 public:
  Fraction() = default;
  Fraction(std::int64_t value) : numerator_(value) {}  // NOLINT: exact, implicit on purpose
  /// numerator / denominator, the denominator not 0.
  Fraction(int128 numerator, int128 denominator);

  /// A decimal or "p/q" of two decimals. Throws Error(kSyntax).
  static Fraction parse(std::string_view text);

  int128 numerator() const { return numerator_; }
  int128 denominator() const { return denominator_; }
  /// The numerator over a multiple of the denominator.
  int128 over(int128 multiple) const;
  double to_double() const { return double(numerator_) / double(denominator_); }
  /// A decimal where it ends, else "p/q".
  std::string text() const;

  friend Fraction operator+(const Fraction& a, const Fraction& b);
  friend Fraction operator-(const Fraction& a, const Fraction& b);
  friend bool operator==(const Fraction&, const Fraction&) = default;
  friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b);

 private:
  int128 numerator_ = 0, denominator_ = 1;
};

/// The least common multiple of two positive numbers.
int128 common_multiple(int128 a, int128 b);
/// 10^exponent, from 0 to 30.
int128 power_of_ten(int exponent);
/// a * b; throws Error(kOutOfRange) from 2^100 on.
int128 bounded_product(int128 a, int128 b);

}  // namespace findspace::packing
