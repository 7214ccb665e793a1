// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// `distance -> min` for maps on rays: the atom becomes `distance <= v` with the least value v, which some position
// takes. Guarantee: the same set where v is proven; else it holds the minimisers and what comes as near to them as v is
// known (distance/solid/solid_least.h), so the map is an outer bound, or an inner one where the atom is negated.
// Keywords: argmin, level set.
#pragma once

#include <string>
#include <vector>

#include "formula/solid/side.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

struct LeastOf {
  std::string text;                       // the atom's
  std::optional<distance::Answer> least;  // in the scene's unit; nothing where undefined: the atom holds nowhere
};

struct MinimaAsLevels {
  Formula formula;
  std::vector<LeastOf> minima;
  Side side = Side::kExact;
};

bool has_minima(const Formula& formula);
/// Throws Error(kUnsupported) where a least value is not computed.
MinimaAsLevels minima_as_levels(const SpaceSolver& solver, const Formula& formula);

}  // namespace findspace::formula
