// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Formulas as text: the canonical spelling, which is also the key of every distance in results ("gamma1(B, A)", one
// blank after the comma), or with the signs of the literature (γ₁(B, A) ≥ 0.5 ∧ ¬(...)). Guarantee:
// parse_formula(text(f)) == f for either script in the context that f was read in. Keywords: pretty printer, unparse,
// canonical form.
#pragma once

#include <cstdint>
#include <string>

#include "formula/language/formula.h"

namespace findspace::formula {

enum class Script : std::uint8_t { kAscii, kSymbols };

std::string text(const Distance& distance, Script script = Script::kAscii);
std::string text(const Atom& atom, Script script = Script::kAscii);
std::string text(const Formula& formula, Script script = Script::kAscii);
std::string text(const Objective& objective, Script script = Script::kAscii);

/// The relation's sign.
std::string text(Relation relation, Script script = Script::kAscii);

/// The exact decimal spelling of a number, e.g. "-0.508"; "" if it has none of at most 30 places.
std::string decimal_text(const exact::Real& value);

}  // namespace findspace::formula
