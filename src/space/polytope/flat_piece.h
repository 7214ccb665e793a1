// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex polygons in space, and segments and points left of them, less open convex polyhedra: F \ S as closed pieces,
// so that what only touches S stays. Every corner is where the plane of the polygon meets two of the planes it was cut
// with, so coordinates do not grow with the number of cuts. Guarantee: exact. Cost: the corners times the planes of a
// set; a corner that is made costs some microseconds. Source: Sutherland, Hodgman 1974. Keywords: polygon clipping,
// polygon difference.
#pragma once

#include <span>
#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::space {

/// Keeps pointers to planes: those of the sets have to outlive it.
struct FlatPiece {
  struct Corner {
    RealVector at;
    Vector near;            // rounded
    const HalfSpace* side;  // holds the edge to the next corner; not parallel to the plane
  };
  const HalfSpace* plane = nullptr;
  std::vector<Corner> corners;  // in circular order; three or more, or the ends of a segment, or a point
};

/// Adds closed pieces whose union is the piece less {x : all planes < 0}.
void subtract(FlatPiece piece, std::span<const HalfSpace> set, std::vector<FlatPiece>& out);

}  // namespace findspace::space
