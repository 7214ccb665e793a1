// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex sets within a union of polyhedra that hold what lies about the walls between its parts. Where a face of P and
// one of Q lie in one plane, from its two sides, the set within all other planes of both is part of P or Q on either
// side of that plane. So a place within a wall, on the boundary of both parts, is an inner one of it. Places at which
// more parts meet are those of bridges between bridges. Guarantee: exact; each set lies within the union. At most
// kMostBridges; of parts without a radius. Cost: the pairs of parts that touch. Keywords: convex decomposition, merging
// of cells, maximal convex sets.
#pragma once

#include <vector>

#include "space/body/body.h"
#include "space/polytope/extent.h"

namespace findspace::space {

inline constexpr std::size_t kMostBridges = 200;

/// A closed set with interior.
struct WallBridge {
  std::vector<HalfSpace> planes;  // of its facets
  Extent extent;
};
/// None lies within a part, or within one before it.
std::vector<WallBridge> wall_bridges(const Body& body);

}  // namespace findspace::space
