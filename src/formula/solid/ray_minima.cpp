// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/ray_minima.h"

#include <algorithm>

#include "formula/language/evaluate.h"
#include "formula/language/text.h"

namespace findspace::formula {

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
    out.minima.push_back({written(atoms[k]), least});
    if (least && !least->proven) out.side = both(out.side, negated ? Side::kInner : Side::kOuter);
    atoms[k] = compare(atoms[k].distance, Relation::kLessEqual, least ? least->value : exact::Real());
  });
  out.formula = Formula(formula.root(), std::move(atoms));
  return out;
}

}  // namespace findspace::formula
