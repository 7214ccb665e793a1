// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All bodies placed at once (distances.md 6.3): for every body and allowed angle the set P of all positions for which
// the others can still be placed, and one complete placement as witness, which keeps the conditions on coordinates:
// body after body, each at its lexicographic minimiser (choose.h) over what the bodies before it leave, or where there
// is none at any position. Angles and alternatives of `or` are enumerated; each
// combination is a pair system. Guarantee: as pair_system.h; without `unproven` the regions are exact, and empty means
// that there is no placement. Cost: a pair system for each combination, and again for each body of the witness.
// Keywords: configuration space.
#pragma once

#include <vector>

#include "planning/order/choose.h"
#include "planning/order/placement.h"

namespace findspace::planning {

/// Of a body: P at each allowed angle.
using SimultaneousPlacement = TogetherOf<std::vector<AtAngle>, exact::RealPoint>;

SimultaneousPlacement place_simultaneously(const Relations& relations, const Limit& limit);

}  // namespace findspace::planning
