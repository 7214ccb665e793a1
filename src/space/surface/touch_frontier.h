// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All positions at which B + p touches the surface of a solid A from outside, or from inside (touch_sets.h). Guarantee:
// as there; the same for any number of threads. Cost: every set near a wanted box, in parallel. Keywords: boundary of a
// Minkowski sum, contact surface, configuration space obstacle.
#pragma once

#include <functional>

#include "space/surface/touch_sets.h"

namespace findspace::space {

struct TouchFrontier {
  std::vector<FlatPiece> pieces;
  std::shared_ptr<const TouchSets> sets;  // whose planes the pieces point to
};

/// Whether pieces in a box are wanted.
using BoxQuery = std::function<bool(const Vector& low, const Vector& high)>;

/// Pieces that lie in no wanted box may be missing.
TouchFrontier touch_frontier(std::shared_ptr<const TouchSets> sets, const BoxQuery& wanted);

}  // namespace findspace::space
