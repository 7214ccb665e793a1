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
constexpr const char* kBeyondCoordinates = "a number too long or too large for any coordinate";

/// A product of this many factors at most, and parentheses this deep.
constexpr int kMostFactors = 16, kMostNested = 8;

bool is_too_long(const std::string& digits) {
  const std::size_t mantissa = std::min(digits.find_first_of("eE"), digits.size());
  if (mantissa > kMostDigits) return true;
  if (mantissa == digits.size()) return false;
  const std::string exponent = digits.substr(mantissa + 1);
  return exponent.size() > 6 || std::abs(std::atoi(exponent.c_str())) > kLargestExponent;
}

/// A pure number and how it was written.
struct Factor {
  exact::Real value;
  std::string written;
};

Factor product(Cursor& cursor, int depth);

Factor decimal(Cursor& cursor) {
  if (!cursor.at(Token::Kind::kNumber)) cursor.fail_syntax("a number is meant here, found {}", cursor.found());
  const Token token = cursor.take();
  if (is_too_long(token.text)) cursor.fail(ErrorCode::kOutOfRange, token.span, "{}", kBeyondCoordinates);
  try {
    return {exact::Real::parse_decimal(token.text), token.text};
  } catch (const Error& error) {
    cursor.fail_with(error.code(), token.span, error.message());
  }
}

/// ( product + product - ... ), without units.
Factor in_parentheses(Cursor& cursor, int depth) {
  const Span open = cursor.take().span;
  if (depth > kMostNested) cursor.fail(ErrorCode::kSyntax, open, "parentheses nested too deeply");
  Factor sum{exact::Real(0), "("};
  bool negative = cursor.at(Token::Kind::kMinus);
  if (negative || cursor.at(Token::Kind::kPlus)) cursor.take();
  while (true) {
    const Factor term = product(cursor, depth);
    sum.value = negative ? sum.value - term.value : sum.value + term.value;
    sum.written += (negative ? "-" : sum.written.size() > 1 ? "+" : "") + term.written;
    negative = cursor.at(Token::Kind::kMinus);
    if (!negative && !cursor.at(Token::Kind::kPlus)) break;
    cursor.take();
  }
  if (cursor.at(Token::Kind::kName))
    cursor.fail_syntax("a unit stands behind the parentheses: (1 + 2)mm, found {}", cursor.found());
  if (!cursor.accept(Token::Kind::kClose)) cursor.fail_unclosed(open);
  sum.written += ")";
  return sum;
}

Factor factor(Cursor& cursor, int depth) {
  return cursor.at(Token::Kind::kOpen) ? in_parentheses(cursor, depth + 1) : decimal(cursor);
}

Factor product(Cursor& cursor, int depth) {
  Factor out = factor(cursor, depth);
  for (int count = 1;; ++count) {
    const bool over = cursor.at(Token::Kind::kOver);
    const Token::Kind next = cursor.peek(1).kind;
    if (!over && !(cursor.at(Token::Kind::kTimes) && (next == Token::Kind::kNumber || next == Token::Kind::kOpen)))
      return out;
    const Span sign = cursor.take().span;
    if (count == kMostFactors) cursor.fail(ErrorCode::kSyntax, sign, "a product of more than {} numbers", kMostFactors);
    const std::size_t begin = cursor.peek().span.begin;
    const Factor by = factor(cursor, depth);
    if (over && by.value.sign() == 0) cursor.fail(ErrorCode::kBadValue, {begin, cursor.end()}, "a division by 0");
    out.value = over ? out.value / by.value : out.value * by.value;
    out.written += (over ? "/" : "*") + by.written;
  }
}

/// The unit that may follow.
void read_unit(Cursor& cursor, Number& number) {
  const Token& next = cursor.peek();
  if (next.kind != Token::Kind::kName) return;
  // A word that touches the number has to be a unit; after a blank it may also be what comes next.
  const bool known = find_unit(next.text).has_value() || next.text == "deg";
  if (!known && next.span.begin > number.span.end) return;
  if (!known) {
    std::vector<std::string> units(kUnitNames.begin(), kUnitNames.end());
    units.emplace_back("deg");
    const std::string near = question(next.text, units);
    cursor.fail(ErrorCode::kUnknownName, next.span, "unknown unit '{}'{}", printable(next.text),
                near.empty() ? fmt::format("; the units are {}", fmt::join(units, ", ")) : near);
  }
  number.unit_span = next.span;
  number.unit = cursor.take().text;
  number.span.end = cursor.end();
}

/// One summand in the scene's unit, and its sign.
exact::Real value_of(const Cursor& cursor, const Context& context, const Number& number, Quantity quantity) {
  exact::Real value = number.negative ? -number.value : number.value;
  if (number.unit.empty()) return value;
  const std::optional<Unit> unit = find_unit(number.unit);
  if (quantity == Quantity::kPure) cursor.fail(ErrorCode::kBadValue, number.unit_span, "a direction carries no unit");
  if (quantity == Quantity::kAngle && unit)
    cursor.fail(ErrorCode::kBadValue, number.unit_span, "a distance in rotation is an angle in degrees, not a length");
  if (quantity == Quantity::kLength && !unit)
    cursor.fail(ErrorCode::kBadValue, number.unit_span, "a length is meant here, not an angle");
  if (unit && !context.unit) {
    cursor.fail(ErrorCode::kBadValue, number.unit_span,
                "the scene has no unit, so numbers cannot carry one; give the scene a \"unit\"");
  }
  return unit ? value * factor(*unit, *context.unit) : value;
}

}  // namespace

bool at_number(const Cursor& cursor) {
  return cursor.at(Token::Kind::kNumber) || cursor.at(Token::Kind::kMinus) || cursor.at(Token::Kind::kPlus);
}

bool at_arithmetic(const Cursor& cursor) { return at_number(cursor) || cursor.at(Token::Kind::kOpen); }

bool at_number_in_parentheses(const Cursor& cursor) {
  if (!cursor.at(Token::Kind::kOpen)) return false;
  Lexer lexer(cursor.rest());
  bool any = false;
  for (int depth = 0; depth <= kMostNested + 1;) {
    switch (lexer.next().kind) {
      case Token::Kind::kOpen:
        ++depth;
        break;
      case Token::Kind::kClose:
        if (--depth == 0) return any;
        break;
      case Token::Kind::kNumber:
        any = true;
        break;
      case Token::Kind::kPlus:
      case Token::Kind::kMinus:
      case Token::Kind::kTimes:
      case Token::Kind::kOver:
        break;
      default:
        return false;
    }
  }
  return false;
}

exact::Real read_decimal(Cursor& cursor) { return decimal(cursor).value; }

Number read_number(Cursor& cursor) {
  Number result;
  result.span.begin = cursor.peek().span.begin;
  if (cursor.at(Token::Kind::kMinus) || cursor.at(Token::Kind::kPlus))
    result.negative = cursor.take().kind == Token::Kind::kMinus;
  Factor read = product(cursor, 0);
  result.value = std::move(read.value);
  result.written = std::move(read.written);
  result.span.end = cursor.end();
  read_unit(cursor, result);
  return result;
}

Number read_total(Cursor& cursor) {
  Number result = read_number(cursor);
  while (cursor.at(Token::Kind::kPlus) || cursor.at(Token::Kind::kMinus)) {
    result.more.push_back(read_number(cursor));
    result.span.end = cursor.end();
  }
  if (cursor.accept(Token::Kind::kTimes))
    cursor.fail_syntax("a number is meant after '*', as in 2 * 0.25mm; found {}", cursor.found());
  return result;
}

Number negated(Number number) {
  number.negative = !number.negative;
  for (Number& term : number.more) term.negative = !term.negative;
  return number;
}

void check_computed(const Cursor& cursor, Span span, const exact::Real& value) {
  if (!has_exact_text(value)) cursor.fail(ErrorCode::kOutOfRange, span, "{}", kBeyondCoordinates);
}

Level level_of(const Cursor& cursor, const Context& context, const Number& number, Quantity quantity) {
  exact::Real value = value_of(cursor, context, number, quantity);
  if (number.more.empty()) return {std::move(value), (number.negative ? "-" : "") + number.written + number.unit};
  for (const Number& term : number.more) value = value + value_of(cursor, context, term, quantity);
  check_computed(cursor, number.span, value);
  return {std::move(value), {}};  // printed as a number
}

std::vector<exact::Real> read_coordinates(Cursor& cursor, const Context& context, Quantity quantity, Token::Kind close,
                                          std::string& text) {
  std::vector<exact::Real> result;
  const std::size_t begin = cursor.peek().span.begin;
  do {
    Level coordinate = level_of(cursor, context, read_total(cursor), quantity);
    const std::string decimal = decimal_text(coordinate.value);
    text += (text.empty() ? "" : ", ") + (!decimal.empty()             ? decimal
                                          : coordinate.written.empty() ? number_text(coordinate.value)
                                                                       : coordinate.written);
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
