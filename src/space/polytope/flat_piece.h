// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex polygons in space, and segments and points of them, cut by planes. Every corner is where the plane of the
// polygon meets two of the planes it was cut with, so coordinates do not grow with the number of cuts. Guarantee:
// exact. Cost: the corners; one that is made costs some microseconds. Source: Sutherland, Hodgman 1974. Keywords:
// polygon clipping, binary space partition.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::space {

/// Keeps pointers to planes: they have to outlive it.
struct FlatPiece {
  struct Corner {
    RealVector at;
    Vector near;            // rounded
    const HalfSpace* side;  // holds the edge to the next corner; not parallel to the plane
  };
  const HalfSpace* plane = nullptr;
  std::vector<Corner> corners;  // in circular order; three or more, or the ends of a segment, or a point
};

/// The closed parts of a polygon below and above a plane; nothing where it has no corners on both sides.
std::optional<std::array<FlatPiece, 2>> split(const FlatPiece& polygon, const HalfSpace& h);

}  // namespace findspace::space
