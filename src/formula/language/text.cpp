// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/text.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "formula/language/lexer.h"

namespace findspace::formula {
namespace {

using Op = Node::Op;

std::string shapes_text(const std::vector<std::string>& shapes) {
  std::string result;
  for (const std::string& shape : shapes) result.append(result.empty() ? "" : "+").append(quoted_if_needed(shape));
  return result;
}

std::string_view word(Mode mode) {
  switch (mode) {
    case Mode::kAlong:
      return "along";
    case Mode::kToward:
      return "toward";
    case Mode::kRotation:
      return "turning";
    case Mode::kPlain:
      break;
  }
  return "";
}

std::string operator_text(Op op, Script script) {
  const bool ascii = script == Script::kAscii;
  if (op == Op::kNot) return ascii ? "not " : "¬";
  if (op == Op::kAnd) return ascii ? " and " : " ∧ ";
  return ascii ? " or " : " ∨ ";
}

/// An operand stands in parentheses if it binds less tightly than its operator.
std::string node_text(const Node& node, const std::vector<Atom>& atoms, Script script) {
  const auto operand_text = [&](const Node& operand) {
    const bool loose = operand.op == Op::kOr || (node.op == Op::kNot && operand.op == Op::kAnd);
    const std::string inner = node_text(operand, atoms, script);
    return loose ? fmt::format("({})", inner) : inner;
  };
  switch (node.op) {
    case Op::kTrue:
      return "true";
    case Op::kFalse:
      return "false";
    case Op::kAtom:
      return text(atoms[node.atom], script);
    case Op::kNot:
      return operator_text(Op::kNot, script) + operand_text(node.operands.front());
    case Op::kAnd:
    case Op::kOr:
      break;
  }
  std::string result = operand_text(node.operands.front());
  for (std::size_t i = 1; i < node.operands.size(); ++i) {
    result += operator_text(node.op, script) + operand_text(node.operands[i]);
  }
  return result;
}

}  // namespace

std::string text(Relation relation, Script script) {
  constexpr std::array<std::string_view, 6> kAscii{"<", "<=", "=", "!=", ">=", ">"};
  constexpr std::array<std::string_view, 6> kSymbols{"<", "≤", "=", "≠", "≥", ">"};
  return std::string((script == Script::kAscii ? kAscii : kSymbols)[static_cast<std::size_t>(relation)]);
}

std::string text(const Distance& distance, Script script) {
  std::string result;
  if (distance.prefix != Extremum::kNone) result = distance.prefix == Extremum::kInf ? "inf " : "sup ";
  result += script == Script::kAscii ? name(distance.kind) : symbol(distance.kind);
  result += fmt::format("({}, {}", shapes_text(distance.first), shapes_text(distance.second));
  if (distance.mode != Mode::kPlain) result += fmt::format(", {}={}", word(distance.mode), distance.vector_text);
  return result + ")";
}

std::string text(const Atom& atom, Script script) {
  const std::string distance = text(atom.distance, script);
  if (atom.minimum) return distance + (script == Script::kAscii ? " -> min" : " → min");
  std::string level = decimal_text(atom.level);
  if (level.empty()) level = atom.written.empty() ? atom.level.text() : atom.written;
  return fmt::format("{} {} {}", distance, text(atom.relation, script), level);
}

std::string text(const Formula& formula, Script script) { return node_text(formula.root(), formula.atoms(), script); }

std::string text(const Objective& objective, Script script) {
  switch (objective.kind) {
    case Objective::Kind::kX:
      return "x";
    case Objective::Kind::kY:
      return "y";
    case Objective::Kind::kZ:
      return "z";
    case Objective::Kind::kDistanceToPoint:
      return "distance to " + objective.point_text;
    case Objective::Kind::kDistance:
      break;
  }
  if (!objective.negated) return text(objective.distance, script);
  // Only eta1 has a word for its negative, and sup of -f is -inf of f.
  Distance margin = objective.distance;
  if (margin.prefix != Extremum::kNone)
    margin.prefix = margin.prefix == Extremum::kInf ? Extremum::kSup : Extremum::kInf;
  const std::string positive = text(margin);
  const std::size_t start = positive.find("eta1(");
  return positive.substr(0, start) + "margin" + positive.substr(start + 4);
}

std::string decimal_text(const exact::Real& value) {
  if (!value.is_rational()) return {};
  constexpr int kMostPlaces = 30;
  exact::Real scaled = value;
  std::optional<exact::int128> integer = scaled.integer();
  int places = 0;
  for (; !integer && places < kMostPlaces; ++places) {
    scaled = scaled * exact::Real(10);
    integer = scaled.integer();
  }
  if (!integer) return {};
  const bool negative = *integer < 0;
  std::string digits;
  // Remainders of negative numbers are negative: no overflow at the most negative one.
  for (exact::int128 rest = *integer; rest != 0 || digits.size() <= static_cast<std::size_t>(places); rest /= 10) {
    const int digit = static_cast<int>(rest % 10);
    digits.insert(digits.begin(), static_cast<char>('0' + (digit < 0 ? -digit : digit)));
  }
  if (places > 0) digits.insert(digits.end() - places, '.');
  return negative ? "-" + digits : digits;
}

}  // namespace findspace::formula
