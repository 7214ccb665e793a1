// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The vertices of a bounded intersection of half spaces, exactly, before they are put on a grid.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "exact/number/real.h"
#include "space/polytope/polytope.h"

namespace findspace::space {

/// A vertex: the point where three planes meet, and the determinant of their normals (its coordinates are integers over
/// it); 0 where that does not fit.
struct PlaneVertex {
  std::array<exact::Real, 3> at;
  int128 determinant = 0;
};

/// May list a vertex more than once. Empty if the intersection is empty. Throws Error(kGeometry) if it is unbounded
/// with an edge, Error(kBadValue) for a plane without normal. Cost O(n^3).
std::vector<PlaneVertex> half_space_vertices(std::span<const Plane> planes);

}  // namespace findspace::space
