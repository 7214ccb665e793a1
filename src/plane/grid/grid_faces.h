// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open faces of a set that is bounded by grid segments alone, as rings of integer corners, the face on their left:
// the short form from which sums of polygons are made. Guarantee: exact. Cost: linear. Keywords: boundary cycles.
#pragma once

#include <optional>
#include <vector>

#include "plane/base/arena.h"
#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// A corner and the edge that leaves it.
struct GridCorner {
  GridPoint at;
  std::int64_t dx, dy;     // primitive direction of the edge
  Index supporting_curve;  // of the edge, in the set's geometry
  Index next, before;      // corners of the same face
  std::int8_t turn = 0;    // from the edge before to this one: +1 left (convex), -1 right (reflex), 0 straight on
};

/// The direction of an edge.
struct EdgeRay {
  double angle;  // grows with the angle in [0, 360)
  Index corner;  // whose edge it is
};

using GridCorners = ArenaVector<GridCorner>;

struct GridFace {
  explicit GridFace(Memory memory) : corners(memory), rays(memory) {}

  GridCorners corners;  // ring by ring
  bool unbounded = false;
  ArenaVector<EdgeRay> rays;  // by angle, where that has been made (edge_fan.h)

  /// One ring that turns left at every corner and round once.
  bool is_convex() const;
};
using GridFaces = ArenaVector<GridFace>;

/// The faces with marks of the given kind. Nothing where a part of the set lies outside the closure of these faces, a
/// face meets an edge from both sides or lacks a single point, or an edge is not a segment between grid points.
/// `mirrored`: of the set reflected through the origin. `memory`: for all that is returned.
std::optional<GridFaces> grid_faces(const CellComplex& complex, bool (*wanted)(Mark), bool mirrored,
                                    Memory memory = kHeap);

}  // namespace findspace::plane
