// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/demands.h"

#include <algorithm>
#include <array>

#include "formula/language/evaluate.h"

namespace findspace::formula {
namespace {

using Op = Node::Op;

void mark_polarity(const Node& node, bool positive, std::vector<bool>& out) {
  if (node.op == Op::kAtom) out[node.atom] = positive;
  for (const Node& operand : node.operands) mark_polarity(operand, positive != (node.op == Op::kNot), out);
}

bool truth_of(const Node& node, bool positive, const std::vector<bool>& met) {
  const auto holds = [&](const Node& operand) { return truth_of(operand, positive, met); };
  switch (node.op) {
    case Op::kTrue:
      return positive;
    case Op::kFalse:
      return !positive;
    case Op::kAtom:
      return met[node.atom];
    case Op::kNot:
      return truth_of(node.operands.front(), !positive, met);
    case Op::kAnd:
    case Op::kOr:
      break;
  }
  const bool all = (node.op == Op::kAnd) == positive;
  return all ? std::all_of(node.operands.begin(), node.operands.end(), holds)
             : std::any_of(node.operands.begin(), node.operands.end(), holds);
}

double measure_of(const Node& node, bool positive, const std::vector<double>& numbers) {
  switch (node.op) {
    case Op::kTrue:
      return positive ? exact::kInfinity : -exact::kInfinity;
    case Op::kFalse:
      return positive ? -exact::kInfinity : exact::kInfinity;
    case Op::kAtom:
      return numbers[node.atom];
    case Op::kNot:
      return measure_of(node.operands.front(), !positive, numbers);
    case Op::kAnd:
    case Op::kOr:
      break;
  }
  const bool all = (node.op == Op::kAnd) == positive;
  double out = all ? exact::kInfinity : -exact::kInfinity;
  for (const Node& operand : node.operands) {
    const double number = measure_of(operand, positive, numbers);
    out = all ? std::min(out, number) : std::max(out, number);
  }
  return out;
}

Formula rebuilt(const Node& node, bool positive, const std::function<Formula(std::size_t)>& part) {
  switch (node.op) {
    case Op::kTrue:
      return constant(positive);
    case Op::kFalse:
      return constant(!positive);
    case Op::kAtom:
      return part(node.atom);
    case Op::kNot:
      return rebuilt(node.operands.front(), !positive, part);
    case Op::kAnd:
    case Op::kOr:
      break;
  }
  std::vector<Formula> operands;
  for (const Node& operand : node.operands) operands.push_back(rebuilt(operand, positive, part));
  return (node.op == Op::kAnd) == positive ? conjunction(operands) : disjunction(operands);
}

}  // namespace

Relation opposite(Relation relation) {
  constexpr std::array kOpposite{Relation::kGreaterEqual, Relation::kGreater, Relation::kNotEqual,
                                 Relation::kEqual,        Relation::kLess,    Relation::kLessEqual};
  return kOpposite[static_cast<std::size_t>(relation)];
}

Demands::Demands(const Formula& formula) : formula_(formula), positive_(formula.atoms().size()) {
  mark_polarity(formula_.root(), true, positive_);
  for (std::size_t k = 0; k < positive_.size(); ++k) {
    const Relation stated = formula_.atoms()[k].relation;
    relations_.push_back(positive_[k] ? stated : opposite(stated));
  }
}

bool Demands::has_level(std::size_t k) const {
  return !formula_.atoms()[k].minimum && relations_[k] != Relation::kNotEqual;
}

bool Demands::holds(std::size_t k, std::int8_t sign) const {
  return formula::holds(formula_.atoms()[k], sign) == positive_[k];
}

double Demands::measure(const std::vector<double>& numbers) const { return measure_of(formula_.root(), true, numbers); }

bool Demands::truth(const std::vector<bool>& met) const { return truth_of(formula_.root(), true, met); }

Formula Demands::demand(std::size_t k) const {
  const Formula atom(formula_.atoms()[k]);
  return positive_[k] ? atom : negation(atom);
}

Formula Demands::demand(std::size_t k, const exact::Real& level) const {
  return Formula(compare(formula_.atoms()[k].distance, relations_[k], level));
}

Formula Demands::with(const std::function<Formula(std::size_t)>& part) const {
  return rebuilt(formula_.root(), true, part);
}

Formula Demands::with(std::size_t k, const Formula& part) const {
  return with([&](std::size_t j) { return j == k ? part : demand(j); });
}

}  // namespace findspace::formula
