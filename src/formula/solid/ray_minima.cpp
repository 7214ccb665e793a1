// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/ray_minima.h"

#include <algorithm>

#include "formula/language/evaluate.h"
#include "formula/language/text.h"

namespace findspace::formula {

namespace {

/// Calls visit(atom, negated) for every leaf.
template <class Visit>
void each_atom(const Node& node, bool negated, const Visit& visit) {
  if (node.op == Node::Op::kAtom) visit(node.atom, negated);
  const bool below = negated != (node.op == Node::Op::kNot);
  for (const Node& operand : node.operands) each_atom(operand, below, visit);
}

}  // namespace

Side both(Side a, Side b) { return a == Side::kExact || a == b ? b : b == Side::kExact ? a : Side::kMixed; }

Side side_of_search(const RayWorld& world, const Formula& formula, const space::RayGrid* grid) {
  Side side = Side::kExact;
  each_atom(formula.root(), false, [&](std::size_t k, bool negated) {
    const Atom& atom = formula.atoms()[k];
    if (atom.minimum || !found_by_search(world, formula.sign_maps()[formula.sign_map_of(k)], grid)) return;
    side = both(side, holds(atom, 0) != negated ? Side::kOuter : Side::kInner);
  });
  return side;
}

std::string_view name(Side side) {
  switch (side) {
    case Side::kExact:
      return "exact";
    case Side::kInner:
      return "inner";
    case Side::kOuter:
      return "outer";
    case Side::kMixed:
      return "mixed";
    default:
      return "none";
  }
}

bool has_minima(const Formula& formula) {
  return std::any_of(formula.sign_maps().begin(), formula.sign_maps().end(),
                     [](const SignMap& m) { return m.minimum; });
}

MinimaAsLevels minima_as_levels(const SpaceSolver& solver, const Formula& formula) {
  MinimaAsLevels out;
  std::vector<Atom> atoms = formula.atoms();
  each_atom(formula.root(), false, [&](std::size_t k, bool negated) {
    if (!atoms[k].minimum) return;
    const auto least = solver.nearly_least(atoms[k].distance);
    out.minima.push_back({text(atoms[k]), least});
    if (least && !least->proven) out.side = both(out.side, negated ? Side::kInner : Side::kOuter);
    atoms[k] = compare(atoms[k].distance, Relation::kLessEqual, least ? least->value : exact::Real());
  });
  out.formula = Formula(formula.root(), std::move(atoms));
  return out;
}

}  // namespace findspace::formula
