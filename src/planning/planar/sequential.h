// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bodies placed one after another (distances.md 6.2): body i at the lexicographic minimiser over
//     N_i = N_i0 and AND_{j placed before} (N_ij + p_j),
// with all conditions whose bodies stand by then. A condition counts when the last of its bodies is placed; one that
// speaks of a body without a position counts no more. Guarantee: exact regions, whiskers and isolated points included;
// where the least value is not taken the body gets no position and `attained` is false; the rest goes on either way.
// Cost: one overlay for each body and angle, of the sets near its positions. Keywords: bottom-left placement, first
// fit, greedy nesting.
#pragma once

#include <vector>

#include "planning/order/choose.h"
#include "planning/order/placement.h"

namespace findspace::planning {

struct Step {
  Chosen chosen;
  std::vector<AtAngle> positions;  // N_i at each allowed angle
};

using SequentialPlacement = SequenceOf<Step, exact::RealPoint>;

SequentialPlacement place_sequentially(const Relations& relations, const Limit& limit);

}  // namespace findspace::planning
