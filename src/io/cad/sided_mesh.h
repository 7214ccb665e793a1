// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A mesh that holds a solid, or lies in it, from one that is near it. Given is a closed mesh M and for each triangle T
// and axis how far a point of the true surface can be from its image on T: at most `off` in each axis, and nothing
// along the axis `even`; and how far each corner was moved to the grid. So with K(T) the hull of the boxes of those
// sizes about the corners of T, the solid lies in M and the K(T), and holds M without them: the boundary of the solid
// can be moved to that of M within the K(T), so no other point changes sides. Each corner is moved by a vector that
// leads the planes of its triangles beyond their K(T), the least found by projections; corners of faces that are
// exact and parallel to two axes stay on them. Then it is proved that the result M' serves: outside, M and every K(T)
// lie in M'; inside, M' lies in M and meets no K(T). Guarantee: exact, by space/surface/real_overlap.h; refused
// where the proof fails. Cost: O(n log n), some 0.1 ms for each triangle. Keywords: conservative tessellation, offset
// mesh, inner and outer approximation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/number/tried.h"
#include "space/convolution/ray_body.h"

namespace findspace::io {

struct NearFace {
  int face = 0;  // faces of the solid have numbers
  bool flat = false;
  std::int64_t off = 0;  // in grid steps
  int even = -1;         // an axis, or -1
};

/// In grid steps.
struct NearMesh {
  space::Triangles surface;
  std::vector<NearFace> faces;                     // of each triangle
  std::vector<std::array<std::int64_t, 3>> moved;  // each corner, to the grid: 0 or 1 in each axis
};

struct SidedMesh {
  space::Triangles surface;
  double most_moved = 0;  // of the corners, in grid steps
};

/// Refused (kUnsupported) with what stands in the way.
exact::Tried<SidedMesh> sided_mesh(const NearMesh& near, bool outside);

}  // namespace findspace::io
