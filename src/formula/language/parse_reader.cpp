// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The cursor, numbers and vectors. Calls and names of shapes are in parse_call.cpp.
#include "formula/language/parse_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

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

NameSet::NameSet(std::size_t most) : slots_(std::bit_ceil(2 * most + 1)) {}

void NameSet::add(std::string_view name) {
  slots_[slot(name)] = name;
  has_empty_ = has_empty_ || name.empty();
}

std::size_t NameSet::slot(std::string_view name) const {
  std::size_t at = std::hash<std::string_view>()(name) & (slots_.size() - 1);
  while (!slots_[at].empty() && slots_[at] != name) at = (at + 1) & (slots_.size() - 1);
  return at;
}

Reader::Reader(std::string_view text, const Context& context)
    : source_(text),
      context_(context),
      lexer_(text),
      known_(context.shapes.size() + context.moving.size() + context.extra.size()) {
  for (std::size_t ahead = 0; ahead <= kAhead; ++ahead) read_ahead(ahead);
  for (const auto* names : {&context.shapes, &context.moving, &context.extra})
    for (const std::string& name : *names) known_.add(name);
}

std::vector<std::string> Reader::names() const {
  std::vector<std::string> out = context_.shapes;
  for (const auto* more : {&context_.moving, &context_.extra}) {
    for (const std::string& name : *more) {
      if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
    }
  }
  return out;
}

const Token& Reader::peek(std::size_t ahead) const {
  const Token& token = window_[(at_ + ahead) % window_.size()];
  if (token.kind == Token::Kind::kFault) fail_with(ErrorCode::kSyntax, token.span, token.text);
  return token;
}

bool Reader::at_word(std::string_view word, std::size_t ahead) const {
  const Token& token = peek(ahead);
  return token.kind == Token::Kind::kName && token.text == word;
}

bool Reader::at_number() const { return at(Token::Kind::kNumber) || at(Token::Kind::kMinus) || at(Token::Kind::kPlus); }

/// After the end, or a fault, there is nothing else.
void Reader::read_ahead(std::size_t ahead) {
  const Token& before = window_[(at_ + ahead + kAhead + 1) % window_.size()];
  const bool last = ahead > 0 && (before.kind == Token::Kind::kEnd || before.kind == Token::Kind::kFault);
  window_[(at_ + ahead) % window_.size()] = last ? before : lexer_.next();
}

const Token& Reader::take() {
  const Token& token = peek();
  if (token.kind == Token::Kind::kEnd) return token;
  end_ = token.span.end;
  at_ = (at_ + 1) % window_.size();
  read_ahead(kAhead);
  return token;
}

bool Reader::accept(Token::Kind kind) {
  if (!at(kind)) return false;
  take();
  return true;
}

bool Reader::accept_word(std::string_view word) {
  if (!at_word(word)) return false;
  take();
  return true;
}

void Reader::fail_with(ErrorCode code, Span span, const std::string& message) const {
  throw source_.error(code, span, message);
}

std::string Reader::found() const {
  const Token& token = peek();
  return token.kind == Token::Kind::kEnd ? "the end" : fmt::format("'{}'", printable(source_.text(token.span)));
}

void Reader::fail_unclosed(Span open) const {
  fail_syntax("missing ')' for the '(' at {}, found {}", source_.place(open), found());
}

std::string Reader::question(std::string_view word, std::span<const std::string> candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() || near == word ? "" : fmt::format("; did you mean '{}'?", printable(near));
}

Number Reader::number() {
  Number result;
  result.span.begin = peek().span.begin;
  if (at(Token::Kind::kMinus) || at(Token::Kind::kPlus)) result.negative = take().kind == Token::Kind::kMinus;
  if (!at(Token::Kind::kNumber)) fail_syntax("a number is meant here, found {}", found());
  result.digits = take().text;
  result.span.end = end();
  const Token& next = peek();
  if (next.kind != Token::Kind::kName) return result;
  // A word that touches the number has to be a unit; after a blank it may also be what comes next.
  const bool known = find_unit(next.text).has_value() || next.text == "deg";
  if (!known && next.span.begin > result.span.end) return result;
  if (!known) {
    std::vector<std::string> units(kUnitNames.begin(), kUnitNames.end());
    units.emplace_back("deg");
    const std::string near = question(next.text, units);
    fail(ErrorCode::kUnknownName, next.span, "unknown unit '{}'{}", printable(next.text),
         near.empty() ? "; units are um mm cm m in mil, and deg" : near);
  }
  result.unit_span = next.span;
  result.unit = take().text;
  result.span.end = end();
  return result;
}

Level Reader::level(const Number& number, Quantity quantity) const {
  if (is_too_long(number.digits)) {
    fail(ErrorCode::kOutOfRange, number.span, "a number too long or too large for any coordinate");
  }
  exact::Real value;
  try {
    value = exact::Real::parse_decimal(number.digits);
  } catch (const Error& error) {
    fail_with(error.code(), number.span, error.message());
  }
  if (number.negative) value = -value;
  if (!number.unit.empty()) {
    const std::optional<Unit> unit = find_unit(number.unit);
    if (quantity == Quantity::kPure) fail(ErrorCode::kBadValue, number.unit_span, "a direction carries no unit");
    if (quantity == Quantity::kAngle && unit) {
      fail(ErrorCode::kBadValue, number.unit_span, "a turning distance is an angle in degrees, not a length");
    }
    if (quantity == Quantity::kLength && !unit) {
      fail(ErrorCode::kBadValue, number.unit_span, "a length is meant here, not an angle");
    }
    if (unit && !context_.unit) {
      fail(ErrorCode::kBadValue, number.unit_span,
           "the scene has no unit, so numbers cannot carry one; give the scene a \"unit\"");
    }
    if (unit) value = value * factor(*unit, *context_.unit);
  }
  return {std::move(value), (number.negative ? "-" : "") + number.digits + number.unit};
}

std::vector<exact::Real> Reader::coordinates(Quantity quantity, Token::Kind close, std::string& text) {
  std::vector<exact::Real> result;
  const std::size_t begin = peek().span.begin;
  do {
    Level coordinate = level(number(), quantity);
    const std::string decimal = decimal_text(coordinate.value);
    text += (text.empty() ? "" : ", ") + (decimal.empty() ? coordinate.written : decimal);
    result.push_back(std::move(coordinate.value));
  } while (accept(Token::Kind::kComma));
  if (!at(close)) {
    fail_syntax("a ',' or '{}' is meant here, found {}", close == Token::Kind::kClose ? ')' : ']', found());
  }
  if (result.size() != static_cast<std::size_t>(context_.dimension)) {
    fail(ErrorCode::kBadValue, {begin, end()}, "{} {} where the scene has {} dimensions", result.size(),
         result.size() == 1 ? "coordinate" : "coordinates", context_.dimension);
  }
  take();
  return result;
}

}  // namespace findspace::formula
