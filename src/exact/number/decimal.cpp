// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/decimal.h"

#include <algorithm>
#include <limits>

#include "exact/number/real_node.h"
#include "findspace/error.h"

namespace findspace::exact {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

[[noreturn]] void refuse(std::string_view text, const char* why, ErrorCode code = ErrorCode::kSyntax) {
  constexpr std::size_t kShown = 40;
  std::string shown(text.substr(0, kShown));
  if (text.size() > kShown) shown += "...";
  throw Error(code, "\"" + shown + "\" " + why);
}

/// Reads digits from `at` on, appending them to `digits`; how many.
std::size_t read_digits(std::string_view text, std::size_t& at, std::string& digits) {
  const std::size_t start = at;
  while (at < text.size() && is_digit(text[at])) digits += text[at++];
  return at - start;
}

/// [+-] digits up to the end of the text; values past kMaxExponent are reported as kMaxExponent * 1000.
std::int64_t read_exponent(std::string_view text, std::size_t at) {
  bool negative = false;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) negative = text[at++] == '-';
  if (at == text.size()) refuse(text, "is not a decimal number");
  std::int64_t value = 0;
  for (; at < text.size(); ++at) {
    if (!is_digit(text[at])) refuse(text, "is not a decimal number");
    if (value < Decimal::kMaxExponent * 1000) value = value * 10 + (text[at] - '0');
  }
  return negative ? -value : value;
}

mpz_class power_of_ten(std::int64_t exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

/// So many digits fit in 63 bits, and so does 10 to this power.
constexpr int kInlineDigits = 18;

}  // namespace

Decimal Decimal::parse(std::string_view text) {
  Decimal result;
  std::size_t at = 0;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) result.negative = text[at++] == '-';
  const std::size_t whole = read_digits(text, at, result.digits);
  std::size_t fraction = 0;
  if (at < text.size() && text[at] == '.') fraction = read_digits(text, ++at, result.digits);
  if (whole + fraction == 0) refuse(text, "is not a decimal number");
  if (at < text.size()) {
    if (text[at] != 'e' && text[at] != 'E') refuse(text, "is not a decimal number");
    result.exponent = read_exponent(text, at + 1);
  }
  result.digits.erase(0, result.digits.find_first_not_of('0'));
  if (result.digits.empty()) return {};  // zero, whatever its sign and exponent
  result.exponent -= static_cast<std::int64_t>(fraction);
  while (result.digits.back() == '0') {
    result.digits.pop_back();
    ++result.exponent;
  }
  const auto size = static_cast<std::int64_t>(result.digits.size());
  if (size > kMaxExponent || result.exponent > kMaxExponent || result.exponent < -kMaxExponent) {
    refuse(text, "has too many digits or too large an exponent", ErrorCode::kOutOfRange);
  }
  return result;
}

Real Decimal::value() const {
  if (digits.empty()) return 0;
  if (exponent >= -kInlineDigits &&
      std::int64_t(digits.size()) + std::max<std::int64_t>(exponent, 0) <= kInlineDigits) {
    std::int64_t above = 0, below = 1;
    for (const char c : digits) above = above * 10 + (c - '0');
    for (std::int64_t e = exponent; e > 0; --e) above *= 10;
    for (std::int64_t e = exponent; e < 0; ++e) below *= 10;
    return Real::ratio(negative ? -above : above, below);
  }
  mpz_class numerator(digits, 10), denominator = 1;
  if (negative) numerator = -numerator;
  if (exponent >= 0) {
    numerator *= power_of_ten(exponent);
  } else {
    denominator = power_of_ten(-exponent);
  }
  return detail::make_real(detail::quadratic_ratio(std::move(numerator), std::move(denominator)));
}

namespace {

/// digits / below times 10 to what stands from the e on, in words; false where that does not fit.
bool take_exponent(std::string_view text, std::int64_t& digits, std::int64_t& below) {
  constexpr std::int64_t kMost = 100000000000000000;  // times 10 it is still a word
  if (text[0] != 'e' && text[0] != 'E') return false;
  text.remove_prefix(1);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() > 2 || !std::all_of(text.begin(), text.end(), is_digit)) return false;
  int exponent = 0;
  for (const char c : text) exponent = exponent * 10 + (c - '0');
  for (; exponent > 0; --exponent) {
    std::int64_t& grows = negative ? below : digits;
    if (!negative && below > 1)
      below /= 10;
    else if (grows > kMost)
      return false;
    else
      grows *= 10;
  }
  return true;
}

}  // namespace

std::optional<std::int64_t> grid_integer(std::string_view text, const Real& step) {
  constexpr std::ptrdiff_t kMostDigits = 17;
  const auto parts = step.fraction();
  if (!parts || (*parts)[0] <= 0 || (*parts)[0] > kMaxGridCoordinate || (*parts)[1] > kMaxGridCoordinate) {
    return std::nullopt;
  }
  const char *at = text.data(), *const end = at + text.size();
  const bool negative = at != end && *at == '-';
  if (negative || (at != end && *at == '+')) ++at;
  const char *const begin = at, *const last = at + std::min(end - at, kMostDigits + 1);
  std::int64_t digits = 0, below = 1;
  for (; at != last && is_digit(*at); ++at) digits = digits * 10 + (*at - '0');
  auto read = at - begin;
  if (at != last && *at == '.') {
    const char* const point = at++;
    for (; at != last && is_digit(*at); ++at) {
      digits = digits * 10 + (*at - '0');
      below *= 10;
    }
    read += at - point - 1;
  }
  if (read == 0 || read > kMostDigits) return std::nullopt;
  if (at != end && !take_exponent({at, end}, digits, below)) return std::nullopt;
  const int128 above = int128(digits) * (*parts)[1], divisor = int128(below) * (*parts)[0];
  constexpr int128 kWord = std::numeric_limits<std::int64_t>::max();
  const bool short_ones = above <= kWord && divisor <= kWord;  // the division of words is ten times faster
  const int128 steps = divisor == 1 ? above
                       : short_ones ? std::int64_t(above) / std::int64_t(divisor)
                                    : above / divisor;
  if (steps * divisor != above || steps > kMaxGridCoordinate) return std::nullopt;
  return static_cast<std::int64_t>(negative ? -steps : steps);
}

}  // namespace findspace::exact
