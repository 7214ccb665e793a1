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

/// A number as written: what it measures is known only when its distance has been read.
struct Number {
  bool negative = false;
  std::string digits, unit;  // unit: "" if it carries none
  Span span, unit_span;
};

enum class Quantity : std::uint8_t { kLength, kAngle, kPure };

/// A number in the scene's unit (or degrees), and as it was written.
struct Level {
  exact::Real value;
  std::string written;
};

/// Whether a number begins here.
bool at_number(const Cursor& cursor);
/// A sign, digits and a unit, as far as they are there; fails where no digits stand.
Number read_number(Cursor& cursor);
/// What the number says in the scene's unit; fails where the unit or the size does not suit.
Level level_of(const Cursor& cursor, const Context& context, const Number& number, Quantity quantity);
/// Numbers up to `close`, as many as the scene has dimensions, and their text without brackets: "1, 2".
std::vector<exact::Real> read_coordinates(Cursor& cursor, const Context& context, Quantity quantity, Token::Kind close,
                                          std::string& text);

}  // namespace findspace::formula
