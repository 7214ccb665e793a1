// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map of the Minkowski sum of two convex polygons: -1 inside, 0 on the boundary, +1 outside. Their convolution
// is one convex ring, the edges of both in the order of their directions. Guarantee: exact. Cost: O(n + m), no
// arrangement. Source: de Berg et al., Computational Geometry, section 13.3. Keywords: edge merging.
#pragma once

#include <optional>

#include "plane/boundary.h"

namespace findspace::plane {

/// Nothing where one of the two is not a bounded convex polygon with vertices on the grid.
std::optional<SignMap> convex_sum(const Part& a, const Part& b);

}  // namespace findspace::plane
