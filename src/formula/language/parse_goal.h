// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Reads the entries of a placement's "minimize": what `minimize` of a scene takes (parse.h), and besides
//     goal    := ["-" | "+"] objective | linear ["=" number] | "grid"
//     linear  := ["-" | "+"] term (("+" | "-") term)*        term := [DECIMAL] ("x" | "y" | "z")
// "form = value" is not an objective but a condition; "grid" asks for a grid point near the minimiser.
// Guarantee: errors as parse_objective(). Keywords: linear form, lexicographic objectives.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "formula/language/parse.h"

namespace findspace::formula {

struct Goal {
  std::optional<Objective> objective;              // a distance, or distance to a point ...
  bool negated = false;                            // ... minus it
  std::optional<std::array<exact::Real, 3>> form;  // or a*x + b*y + c*z, not 0 everywhere, c = 0 in 2D ...
  std::optional<exact::Real> equals;               // ... with the value it must have, in the scene's unit
  bool grid = false;                               // or "grid"
};

Goal parse_goal(std::string_view text, const Context& context);

}  // namespace findspace::formula
