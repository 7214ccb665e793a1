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

std::string_view mode_word(const Distance& distance) {
  switch (distance.mode) {
    case Mode::kAlong:
      return "along";
    case Mode::kToward:
      return "toward";
    case Mode::kRotation:
      return distance.turning ? "turning" : "rotating";
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
template <class AtomText>
std::string node_text(const Node& node, const AtomText& atom_text, Script script) {
  const auto operand_text = [&](const Node& operand) {
    const bool loose = operand.op == Op::kOr || (node.op == Op::kNot && operand.op == Op::kAnd);
    const std::string inner = node_text(operand, atom_text, script);
    return loose ? fmt::format("({})", inner) : inner;
  };
  switch (node.op) {
    case Op::kTrue:
      return "true";
    case Op::kFalse:
      return "false";
    case Op::kAtom:
      return atom_text(node.atom);
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

namespace {

std::string distance_text(const Distance& distance, std::string_view word_of_it) {
  std::string result;
  if (distance.prefix != Extremum::kNone) result = distance.prefix == Extremum::kInf ? "inf " : "sup ";
  result += word_of_it;
  result += fmt::format("({}, {}", shapes_text(distance.first), shapes_text(distance.second));
  if (distance.mode != Mode::kPlain) result += fmt::format(", {}={}", mode_word(distance), distance.vector_text);
  return result + ")";
}

/// The level, or minus it where `minus`.
std::string level_text(const Atom& atom, bool minus) {
  const exact::Real level = minus ? -atom.level : atom.level;
  const std::string decimal = decimal_text(level);
  if (!decimal.empty()) return decimal;
  if (atom.written.empty()) return number_text(level);
  if (!minus) return atom.written;
  return atom.written.starts_with('-') ? atom.written.substr(1) : "-" + atom.written;
}

}  // namespace

std::string text(const Distance& distance, Script script) {
  return distance_text(distance, script == Script::kAscii ? name(distance.kind) : symbol(distance.kind));
}

namespace {

/// "gap(B, A) - 2 * gap(B, C)"; `word` writes a distance.
template <class Word>
std::string sum_text(std::span<const SumTerm> terms, const Word& word, bool negated_words) {
  std::string out;
  for (const SumTerm& t : terms) {
    const bool minus = (t.weight.sign() < 0) != (negated_words && negated(t.distance));
    const std::string factor = number_text(exact::abs(t.weight));
    out += out.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
    out += (factor == "1" ? "" : factor + " * ") + word(t.distance);
  }
  return out;
}

std::vector<SumTerm> all_terms(const Atom& atom) {
  std::vector<SumTerm> out{{exact::Real(1), atom.distance}};
  out.insert(out.end(), atom.more.begin(), atom.more.end());
  return out;
}

}  // namespace

std::string text(const Atom& atom, Script script) {
  const std::string distance = sum_text(
      all_terms(atom), [&](const Distance& d) { return text(d, script); }, false);
  if (atom.minimum) return distance + (script == Script::kAscii ? " -> min" : " → min");
  return fmt::format("{} {} {}", distance, text(atom.relation, script), level_text(atom, false));
}

std::string text(const Formula& formula, Script script) {
  return node_text(
      formula.root(), [&](std::size_t k) { return text(formula.atoms()[k], script); }, script);
}

bool negated(const Distance& distance) { return distance.spelled != nullptr && distance.spelled->negated; }

std::string written(const Distance& distance) {
  if (distance.lists.size() == 2)
    return fmt::format("between({}, {})", shapes_text({distance.lists[0]}), shapes_text({distance.lists[1]}));
  if (distance.spelled == nullptr) return text(distance);
  Distance said = distance;
  if (distance.spelled->exchanged) std::swap(said.first, said.second);
  if (negated(distance)) said.prefix = opposite(said.prefix);
  return distance_text(said, distance.spelled->name);
}

std::string written_sum(const Atom& atom) {
  std::vector<SumTerm> terms = all_terms(atom);
  if (negated(atom.distance))
    for (SumTerm& t : terms) t.weight = -t.weight;
  const auto word = [](const Distance& d) { return written(d); };
  return sum_text(terms, word, true);
}

std::string written(const Atom& atom) {
  if (!atom.more.empty()) {
    const bool minus = negated(atom.distance);
    return fmt::format("{} {} {}", written_sum(atom), text(minus ? mirrored(atom.relation) : atom.relation),
                       level_text(atom, minus));
  }
  const bool from_word = atom.predicate != nullptr && atom.predicate->level != PredicateName::Level::kNone;
  const bool mirrors = atom.predicate != nullptr ? atom.predicate->negated : negated(atom.distance);
  const std::string level = level_text(atom, mirrors);
  if (atom.predicate == nullptr) {
    if (atom.minimum) return written(atom.distance) + " -> min";
    const Relation relation = mirrors ? mirrored(atom.relation) : atom.relation;
    return fmt::format("{} {} {}", written(atom.distance), text(relation), level);
  }
  const bool said = from_word && (atom.predicate->level == PredicateName::Level::kRequired || atom.level.sign() != 0);
  return fmt::format("{}({}, {}{})", atom.predicate->name, shapes_text(atom.distance.first),
                     shapes_text(atom.distance.second), said ? ", " + level : "");
}

std::string written(const Formula& formula) {
  return node_text(
      formula.root(), [&](std::size_t k) { return written(formula.atoms()[k]); }, Script::kAscii);
}

PlainText plain(std::string_view canonical) {
  const std::size_t open = canonical.find('(');
  const std::size_t blank = canonical.rfind(' ', open);
  const std::size_t start = blank == std::string_view::npos ? 0 : blank + 1;
  const DistanceName* const row = find_distance(canonical.substr(start, open - start));
  if (row == nullptr) return {std::string(canonical)};
  const DistanceName& word = plain_name(row->kind);
  std::string prefix(canonical.substr(0, start));
  if (word.negated && !prefix.empty()) prefix = prefix == "inf " ? "sup " : "inf ";
  return {prefix + std::string(word.name) + std::string(canonical.substr(open)), word.negated};
}

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
    case Objective::Kind::kSum: {
      const auto word = [&](const Distance& d) { return script == Script::kAscii ? written(d) : text(d, script); };
      return sum_text(objective.terms, word, script == Script::kAscii);
    }
    case Objective::Kind::kDistance:
      break;
  }
  if (script == Script::kSymbols && !objective.negated) return text(objective.distance, script);
  Distance said = objective.distance;  // minus eta1 is `margin`
  if (objective.negated && !negated(said)) said.spelled = &plain_name(said.kind);
  return (negated(said) == objective.negated ? "" : "-") + written(said);
}

std::string question(std::string_view word, std::span<const std::string> candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() || near == word ? "" : fmt::format("; did you mean '{}'?", printable(near));
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

std::string number_text(const exact::Real& value) {
  if (std::string decimal = decimal_text(value); !decimal.empty()) return decimal;
  const auto fraction = value.fraction();
  if (!fraction) return value.text();
  return decimal_text(exact::Real((*fraction)[0])) + "/" + decimal_text(exact::Real((*fraction)[1]));
}

bool has_exact_text(const exact::Real& value) { return value.fraction() || !decimal_text(value).empty(); }

}  // namespace findspace::formula
