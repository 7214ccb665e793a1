// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/side.h"

#include "formula/language/evaluate.h"

namespace findspace::formula {

Side side_of_search(const Formula& formula, const std::vector<bool>& searched) {
  Side side = Side::kExact;
  each_atom(formula.root(), false, [&](std::size_t k, bool negated) {
    const Atom& atom = formula.atoms()[k];
    if (atom.minimum || !searched[formula.sign_map_of(k)]) return;
    side = both(side, holds(atom, 0) != negated ? Side::kOuter : Side::kInner);
  });
  return side;
}

}  // namespace findspace::formula
