// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The truth of a formula from the signs of its sign maps. The compiled form is a chain of decisions: each instruction
// looks at one sign and names its successor for either outcome, so `and`, `or` and `not` cost nothing at run time, and
// operands that cannot matter any more are skipped. No allocation; at most one step for each atom, about a nanosecond
// each. Source: short-circuit code, Aho, Sethi, Ullman, "Compilers", section 8.4 (jumping code).
#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "formula/language/formula.h"

namespace findspace::formula {

/// Which signs satisfy a relation: bit 0 for -1, bit 1 for 0, bit 2 for +1.
std::uint32_t accepted_signs(Relation relation);

/// Whether `atom` holds where its sign map has `sign` (-1, 0 or +1).
bool holds(const Atom& atom, std::int8_t sign);

/// The truth of the formula where sign map k has the sign signs[k], for every k < formula.sign_maps().size().
inline bool evaluate(const Formula& formula, std::span<const std::int8_t> signs) {
  assert(signs.size() >= formula.sign_maps().size());
  const Instruction* const program = formula.program().data();
  std::int32_t at = formula.entry();
  while (at >= 0) {
    const Instruction& step = program[at];
    at = (step.accepted >> (signs[step.sign_map] + 1) & 1u) != 0 ? step.on_true : step.on_false;
  }
  return at == Instruction::kTrue;
}

struct Program {
  std::vector<Instruction> instructions;
  std::int32_t entry = Instruction::kTrue;
};

/// The chain of decisions for a tree over `atoms`, atom k being decided by sign map sign_map_of[k].
Program compile(const Node& root, std::span<const Atom> atoms, std::span<const std::size_t> sign_map_of);

/// Of signs known between bounds only, low and high in turn for every sign map of the formula: 2 where it holds
/// whatever they are, 1 where it holds for some, else 0. With more than eight open signs it may be 1 where the formula
/// looks at one of them several times.
std::int8_t certainty(const Formula& formula, std::span<const std::int8_t> bounds);

}  // namespace findspace::formula
