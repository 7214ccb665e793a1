// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula that holds wherever the original certainly holds for every shape that is near the moving one, and one that holds wherever the
// original may. "Near": contains the shape eroded by a bound, lies in the shape grown by it, and is reached without any
// point of it travelling further. See pose_stack.h for the reasons. Guarantee: conservative on the side asked for.
#pragma once

#include <string>
#include <vector>

#include "situation/formula.h"

namespace findspace::planning {

/// How the variants of a moving shape are called.
std::string eroded_name(const std::string& shape);
std::string grown_name(const std::string& shape);

enum class Certainty { kCertain, kPossible };

/// `bound` in the scene's unit; the formula that comes back may speak of eroded and grown shapes.
situation::Formula hedged(const situation::Formula& formula, const std::vector<std::string>& moving, const exact::Real& bound,
                          Certainty certainty);

}  // namespace findspace::planning
