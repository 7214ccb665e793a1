// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Numbers of a formula, with their units. Private to src/formula; users include parse.h. Guarantee: exact, in the
// scene's unit; an Error at the number or its unit otherwise. Cost: linear.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formula/language/cursor.h"
#include "formula/language/parse.h"

namespace findspace::formula {

/// A number as written, such as -2 * 0.25mm: what it measures is known only when its distance has been read.
struct Number {
  bool negative = false;
  exact::Real value;          // without sign and unit
  std::string written, unit;  // unit: "" if it carries none
  Span span, unit_span;
  std::vector<Number> more;  // further summands, of a total
};

enum class Quantity : std::uint8_t { kLength, kAngle, kPure };

/// A number in the scene's unit (or degrees), and as it was written.
struct Level {
  exact::Real value;
  std::string written;
};

/// Whether a number begins here, without parentheses around it.
bool at_number(const Cursor& cursor);
/// Whether a number begins here, or one in parentheses.
bool at_arithmetic(const Cursor& cursor);
/// Whether parentheses begin here that hold numbers alone.
bool at_number_in_parentheses(const Cursor& cursor);
/// The decimal that stands here, without sign and unit.
exact::Real read_decimal(Cursor& cursor);
/// A sign, a product or quotient of decimals and totals in parentheses, and a unit, as far as they are there. What
/// follows a last `*` may be a distance: that `*` is left.
Number read_number(Cursor& cursor);
/// Numbers joined by + and -, each with its unit.
Number read_total(Cursor& cursor);
/// Minus the number.
Number negated(Number number);
/// Fails at `span` where a number that was computed has no exact text: no coordinate is so large, or so fine.
void check_computed(const Cursor& cursor, Span span, const exact::Real& value);
/// What the number says in the scene's unit; fails where the unit or the size does not suit.
Level level_of(const Cursor& cursor, const Context& context, const Number& number, Quantity quantity);
/// Numbers up to `close`, as many as the scene has dimensions, and their text without brackets: "1, 2".
std::vector<exact::Real> read_coordinates(Cursor& cursor, const Context& context, Quantity quantity, Token::Kind close,
                                          std::string& text);

}  // namespace findspace::formula
