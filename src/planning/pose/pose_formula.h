// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula that holds wherever the original certainly holds for every shape that is near the moving one, and one that
// holds wherever the original may. "Near": contains the shape eroded by a bound, lies in the shape grown by it, and is
// reached without any point of it travelling further. See pose_stack.h for the reasons. Guarantee: conservative on the
// side asked for.
#pragma once

#include <string>
#include <vector>

#include "formula/language/formula.h"

namespace findspace::planning {

enum class Certainty { kCertain, kPossible };

/// A shape grown by `by` (in the scene's unit), or eroded where that is negative.
struct Variant {
  std::string name, of;
  exact::Real by;
};

struct Hedged {
  formula::Formula formula;       // may speak of variants of the shapes
  std::vector<Variant> variants;  // each name once
};

/// `bound` in the scene's unit.
Hedged hedged(const formula::Formula& formula, const std::vector<std::string>& moving, const exact::Real& bound,
              Certainty certainty);

}  // namespace findspace::planning
