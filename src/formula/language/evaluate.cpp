// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/evaluate.h"

#include <functional>
#include <utility>
#include <vector>

namespace findspace::formula {
namespace {

class Compiler {
 public:
  Compiler(std::span<const Atom> atoms, std::span<const std::size_t> sign_map_of)
      : atoms_(atoms), sign_map_of_(sign_map_of) {}

  /// Adds the code of `node`, which is to go on at on_true or on_false; gives the place where it begins. Operands are
  /// compiled from the last to the first, since each has to know where the next one begins.
  std::int32_t add(const Node& node, std::int32_t on_true, std::int32_t on_false) {
    switch (node.op) {
      case Node::Op::kTrue:
        return on_true;
      case Node::Op::kFalse:
        return on_false;
      case Node::Op::kNot:
        return add(node.operands.front(), on_false, on_true);
      case Node::Op::kAtom:
        return add_atom(node.atom, on_true, on_false);
      case Node::Op::kAnd:
        for (auto operand = node.operands.rbegin(); operand != node.operands.rend(); ++operand) {
          on_true = add(*operand, on_true, on_false);
        }
        return on_true;
      case Node::Op::kOr:
        for (auto operand = node.operands.rbegin(); operand != node.operands.rend(); ++operand) {
          on_false = add(*operand, on_true, on_false);
        }
        return on_false;
    }
    return on_false;
  }

  std::vector<Instruction> take() { return std::move(instructions_); }

 private:
  std::int32_t add_atom(std::size_t index, std::int32_t on_true, std::int32_t on_false) {
    const auto sign_map = static_cast<std::uint32_t>(sign_map_of_[index]);
    instructions_.push_back({sign_map, accepted_signs(atoms_[index].relation), on_true, on_false});
    return static_cast<std::int32_t>(instructions_.size()) - 1;
  }

  std::span<const Atom> atoms_;
  std::span<const std::size_t> sign_map_of_;
  std::vector<Instruction> instructions_;
};

}  // namespace

std::uint32_t accepted_signs(Relation relation) {
  switch (relation) {
    case Relation::kLess:
      return 0b001;
    case Relation::kLessEqual:
      return 0b011;
    case Relation::kEqual:
      return 0b010;
    case Relation::kNotEqual:
      return 0b101;
    case Relation::kGreaterEqual:
      return 0b110;
    case Relation::kGreater:
      return 0b100;
  }
  return 0;
}

bool holds(const Atom& atom, std::int8_t sign) { return (accepted_signs(atom.relation) >> (sign + 1) & 1u) != 0; }

Program compile(const Node& root, std::span<const Atom> atoms, std::span<const std::size_t> sign_map_of) {
  Compiler compiler(atoms, sign_map_of);
  const std::int32_t entry = compiler.add(root, Instruction::kTrue, Instruction::kFalse);
  return {compiler.take(), entry};
}

namespace {

std::int8_t certainty(bool may_hold, bool may_fail) { return std::int8_t(!may_hold ? 0 : may_fail ? 1 : 2); }

/// As if every decision met signs of its own: right, but where a formula looks at one sign several times it may say 1
/// for what is 2 or 0. An instruction comes before those that lead to it.
std::int8_t certainty_of_steps(const Formula& formula, std::span<const std::int8_t> bounds) {
  const auto program = formula.program();
  std::vector<char> reached(program.size());
  bool may_hold = false, may_fail = false;
  const auto go_on = [&](std::int32_t at) {
    (at == Instruction::kTrue ? may_hold : may_fail) |= at < 0;
    if (at >= 0) reached[std::size_t(at)] = 1;
  };
  go_on(formula.entry());
  for (std::size_t at = program.size(); at-- > 0;) {
    if (!reached[at]) continue;
    const Instruction& step = program[at];
    for (std::int8_t s = bounds[2 * step.sign_map]; s <= bounds[2 * step.sign_map + 1]; ++s)
      go_on((step.accepted >> (s + 1) & 1u) != 0 ? step.on_true : step.on_false);
  }
  return certainty(may_hold, may_fail);
}

}  // namespace

std::int8_t certainty(const Formula& formula, std::span<const std::int8_t> bounds) {
  constexpr std::size_t kMostTried = 8;  // open signs, of which every combination is tried
  const std::size_t n = formula.sign_maps().size();
  std::size_t open = 0;
  for (std::size_t k = 0; k < n; ++k) open += bounds[2 * k] != bounds[2 * k + 1];
  if (open > kMostTried) return certainty_of_steps(formula, bounds);
  std::vector<std::int8_t> signs(n);
  bool may_hold = false, may_fail = false;
  std::function<void(std::size_t)> choose = [&](std::size_t k) {
    if (may_hold && may_fail) return;
    if (k == n) {
      (evaluate(formula, signs) ? may_hold : may_fail) = true;
      return;
    }
    for (std::int8_t s = bounds[2 * k]; s <= bounds[2 * k + 1]; ++s) {
      signs[k] = s;
      choose(k + 1);
    }
  };
  choose(0);
  return certainty(may_hold, may_fail);
}

}  // namespace findspace::formula
