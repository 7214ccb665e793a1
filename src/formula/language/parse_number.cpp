// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/parse_number.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "formula/language/text.h"

namespace findspace::formula {
namespace {

/// Numbers beyond these bounds cannot be coordinates of any scene, and would cost time without limit.
constexpr std::size_t kMostDigits = 100;
constexpr int kLargestExponent = 100;

bool is_too_long(const std::string& digits) {
  const std::size_t mantissa = std::min(digits.find_first_of("eE"), digits.size());
  if (mantissa > kMostDigits) return true;
  if (mantissa == digits.size()) return false;
  const std::string exponent = digits.substr(mantissa + 1);
  return exponent.size() > 6 || std::abs(std::atoi(exponent.c_str())) > kLargestExponent;
}

}  // namespace

bool at_number(const Cursor& cursor) {
  return cursor.at(Token::Kind::kNumber) || cursor.at(Token::Kind::kMinus) || cursor.at(Token::Kind::kPlus);
}

Number read_number(Cursor& cursor) {
  Number result;
  result.span.begin = cursor.peek().span.begin;
  if (cursor.at(Token::Kind::kMinus) || cursor.at(Token::Kind::kPlus))
    result.negative = cursor.take().kind == Token::Kind::kMinus;
  if (!cursor.at(Token::Kind::kNumber)) cursor.fail_syntax("a number is meant here, found {}", cursor.found());
  result.digits = cursor.take().text;
  result.span.end = cursor.end();
  const Token& next = cursor.peek();
  if (next.kind != Token::Kind::kName) return result;
  // A word that touches the number has to be a unit; after a blank it may also be what comes next.
  const bool known = find_unit(next.text).has_value() || next.text == "deg";
  if (!known && next.span.begin > result.span.end) return result;
  if (!known) {
    std::vector<std::string> units(kUnitNames.begin(), kUnitNames.end());
    units.emplace_back("deg");
    const std::string near = question(next.text, units);
    cursor.fail(ErrorCode::kUnknownName, next.span, "unknown unit '{}'{}", printable(next.text),
                near.empty() ? "; units are um mm cm m in mil, and deg" : near);
  }
  result.unit_span = next.span;
  result.unit = cursor.take().text;
  result.span.end = cursor.end();
  return result;
}

Level level_of(const Cursor& cursor, const Context& context, const Number& number, Quantity quantity) {
  if (is_too_long(number.digits)) {
    cursor.fail(ErrorCode::kOutOfRange, number.span, "a number too long or too large for any coordinate");
  }
  exact::Real value;
  try {
    value = exact::Real::parse_decimal(number.digits);
  } catch (const Error& error) {
    cursor.fail_with(error.code(), number.span, error.message());
  }
  if (number.negative) value = -value;
  if (!number.unit.empty()) {
    const std::optional<Unit> unit = find_unit(number.unit);
    if (quantity == Quantity::kPure) cursor.fail(ErrorCode::kBadValue, number.unit_span, "a direction carries no unit");
    if (quantity == Quantity::kAngle && unit) {
      cursor.fail(ErrorCode::kBadValue, number.unit_span,
                  "a distance in rotation is an angle in degrees, not a length");
    }
    if (quantity == Quantity::kLength && !unit) {
      cursor.fail(ErrorCode::kBadValue, number.unit_span, "a length is meant here, not an angle");
    }
    if (unit && !context.unit) {
      cursor.fail(ErrorCode::kBadValue, number.unit_span,
                  "the scene has no unit, so numbers cannot carry one; give the scene a \"unit\"");
    }
    if (unit) value = value * factor(*unit, *context.unit);
  }
  return {std::move(value), (number.negative ? "-" : "") + number.digits + number.unit};
}

std::vector<exact::Real> read_coordinates(Cursor& cursor, const Context& context, Quantity quantity, Token::Kind close,
                                          std::string& text) {
  std::vector<exact::Real> result;
  const std::size_t begin = cursor.peek().span.begin;
  do {
    Level coordinate = level_of(cursor, context, read_number(cursor), quantity);
    const std::string decimal = decimal_text(coordinate.value);
    text += (text.empty() ? "" : ", ") + (decimal.empty() ? coordinate.written : decimal);
    result.push_back(std::move(coordinate.value));
  } while (cursor.accept(Token::Kind::kComma));
  if (!cursor.at(close)) {
    cursor.fail_syntax("a ',' or '{}' is meant here, found {}", close == Token::Kind::kClose ? ')' : ']',
                       cursor.found());
  }
  if (result.size() != static_cast<std::size_t>(context.dimension)) {
    cursor.fail(ErrorCode::kBadValue, {begin, cursor.end()}, "{} {} where the scene has {} dimensions", result.size(),
                result.size() == 1 ? "coordinate" : "coordinates", context.dimension);
  }
  cursor.take();
  return result;
}

}  // namespace findspace::formula
