// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A layout made shorter by rotating its parts a little, each within its tilt, as a last refinement: programs that move
// and rotate all parts at once (tilting_moves.h), each followed by compaction at the new angles. Guarantee: layouts
// given are feasible, exactly, and none is longer than the one before. Cost: the no-fit polygons of neighbours at new
// angles for each program. Keywords: continuous rotation, tilt, compaction.
#pragma once

#include <functional>

#include "packing/problem/problem.h"

namespace findspace::packing {

/// Whether some part may be tilted.
bool may_tilt(const Problem& problem);

/// The problem whose parts may stand as they do in the layout as well.
Problem with_angles_of(const Problem& problem, const Layout& layout);

/// The last layout. `better` is called with each; `is_over` is asked before each program.
Layout tilted(const Problem& problem, Layout layout, const std::function<void(const Layout&)>& better,
              const std::function<bool()>& is_over);

}  // namespace findspace::packing
