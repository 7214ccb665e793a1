// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/certain_cells.h"

#include <array>

#include "findspace/error.h"
#include "formula/language/text.h"

namespace findspace::formula {

using exact::Real;

namespace {

/// Two relations to levels `by` below and above, both or either.
Formula band(const Atom& atom, Relation below, Relation above, const Real& by, bool both) {
  const std::array<Formula, 2> sides{Formula(compare(atom.distance, below, atom.level - by)),
                                     Formula(compare(atom.distance, above, atom.level + by))};
  return both ? conjunction(sides) : disjunction(sides);
}

Formula moved(const Atom& atom, const Real& by, bool wider) {
  if (atom.distance.mode != Mode::kPlain || atom.distance.prefix != Extremum::kNone)
    throw Error(ErrorCode::kUnsupported, written(atom.distance) + " is not known to change slowly: no certain cells");
  if (by.sign() == 0) return Formula(atom);
  const Real up = wider ? by : -by;
  switch (atom.relation) {
    case Relation::kLess:
    case Relation::kLessEqual:
      return Formula(compare(atom.distance, wider ? Relation::kLessEqual : Relation::kLess, atom.level + up));
    case Relation::kGreater:
    case Relation::kGreaterEqual:
      return Formula(compare(atom.distance, wider ? Relation::kGreaterEqual : Relation::kGreater, atom.level - up));
    case Relation::kEqual:
      return wider ? band(atom, Relation::kGreaterEqual, Relation::kLessEqual, by, true) : constant(false);
    default:
      return wider ? constant(true) : band(atom, Relation::kLess, Relation::kGreater, by, false);
  }
}

Formula changed(const Formula& formula, const Node& node, const Real& by, bool wider) {
  switch (node.op) {
    case Node::Op::kTrue:
    case Node::Op::kFalse:
      return constant(node.op == Node::Op::kTrue);
    case Node::Op::kAtom:
      return moved(formula.atoms()[node.atom], by, wider);
    case Node::Op::kNot:
      return negation(changed(formula, node.operands[0], by, !wider));
    default: {
      std::vector<Formula> parts;
      for (const Node& operand : node.operands) parts.push_back(changed(formula, operand, by, wider));
      return node.op == Node::Op::kAnd ? conjunction(parts) : disjunction(parts);
    }
  }
}

}  // namespace

Formula widened(const Formula& formula, const Real& by) { return changed(formula, formula.root(), by, true); }

Formula narrowed(const Formula& formula, const Real& by) { return changed(formula, formula.root(), by, false); }

}  // namespace findspace::formula
