// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The touching position (touch_sets.h) nearest to p, or farthest from it. Boxes about triangles less a part of B are
// divided nearest (farthest) first; so only sets that may hold it are made, and only facets that may are cut.
// Guarantee: exact; doubles choose what is compared. Cost: the facets that are nearer (farther) before they are cut; on
// smooth surfaces a few hundred. Source: docs/decisions/0016. Keywords: penetration depth, branch and bound.
#pragma once

#include <optional>

#include "space/touch_sets.h"

namespace findspace::space {

/// Nothing where there are none.
std::optional<RealVector> nearest_touch(const TouchSets& sets, const RealVector& p);
std::optional<RealVector> farthest_touch(const TouchSets& sets, const RealVector& p);

}  // namespace findspace::space
