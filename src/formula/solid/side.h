// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// On which side of the true set a set may lie (distance/answer/side.h) whose sign maps are 0 near their levels as well
// as at them. Keywords: inner and outer approximation.
#pragma once

#include <vector>

#include "distance/answer/side.h"
#include "formula/language/formula.h"

namespace findspace::formula {

using distance::both;
using distance::name;
using distance::Side;

/// `searched`: for each sign map of the formula whether a search tells it.
Side side_of_search(const Formula& formula, const std::vector<bool>& searched);

/// Calls visit(atom, negated) for every leaf.
template <class Visit>
void each_atom(const Node& node, bool negated, const Visit& visit) {
  if (node.op == Node::Op::kAtom) visit(node.atom, negated);
  const bool below = negated != (node.op == Node::Op::kNot);
  for (const Node& operand : node.operands) each_atom(operand, below, visit);
}

}  // namespace findspace::formula
