// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Formulas as text: the canonical spelling, which is also the key of every distance in results ("gamma1(B, A)", one
// blank after the comma), with the signs of the literature (γ₁(B, A) ≥ 0.5 ∧ ¬(...)). Guarantee:
// parse_formula(text(f)) == f for either script in the context that f was read in. Keywords: pretty printer, unparse,
// canonical form.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "formula/language/formula.h"

namespace findspace::formula {

enum class Script : std::uint8_t { kAscii, kSymbols };

std::string text(const Distance& distance, Script script = Script::kAscii);
std::string text(const Atom& atom, Script script = Script::kAscii);
std::string text(const Formula& formula, Script script = Script::kAscii);
std::string text(const Objective& objective, Script script = Script::kAscii);

/// As its writer named it: gap(B, A), margin(B, A) >= 1, inside(B, A, 1), with one blank after a comma. What names no
/// word is written canonically. `negated`: the value of the word is minus that of the canonical distance.
std::string written(const Distance& distance);
std::string written(const Atom& atom);
std::string written(const Formula& formula);
bool negated(const Distance& distance);
/// The sum that an atom compares, in the words of its writer: "gap(B, A) - gap(B, C)".
std::string written_sum(const Atom& atom);

/// A canonical spelling in the plain word of its distance: eta1(B, A) is minus margin(B, A), inf eta1 minus sup margin.
struct PlainText {
  std::string text;
  bool negated = false;
};
PlainText plain(std::string_view canonical);

/// The relation's sign.
std::string text(Relation relation, Script script = Script::kAscii);

/// "; did you mean 'X'?" of the candidate nearest to the word, or "".
std::string question(std::string_view word, std::span<const std::string> candidates);

/// The exact decimal spelling of a number, e.g. "-0.508"; "" if it has none of at most 30 places.
std::string decimal_text(const exact::Real& value);
/// A number as a formula reads it: a decimal, else "p/q"; rounded where it has no such text.
std::string number_text(const exact::Real& value);
/// Whether number_text is exact: it is where p and q are below 2^127.
bool has_exact_text(const exact::Real& value);

}  // namespace findspace::formula
