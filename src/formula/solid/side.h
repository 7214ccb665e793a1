// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// On which side of the true set a set may lie whose sign maps are 0 near their levels as well as at them. Keywords:
// inner and outer approximation.
#pragma once

#include <string_view>
#include <vector>

#include "formula/language/formula.h"

namespace findspace::formula {

/// kNone: nothing is claimed.
enum class Side { kExact, kInner, kOuter, kMixed, kNone };
std::string_view name(Side side);
Side both(Side a, Side b);

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
