// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The cell complex of rings of segments and arcs: the sign map of the open set that they bound (-1 inside, 0 on the
// boundary, +1 outside), or a set.
// Guarantee: exact, for rings that do not touch each other or themselves and have no straight corners. Cost: linear;
// where the nesting is not known, besides a vertical ray a ring through trees of boxes. Keywords: boundary cycles.
#pragma once

#include <span>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// A corner of a ring and the x-monotone curve that leaves it, the inside on its left.
struct RingEdge {
  Index point, supporting_curve;
  bool right;            // it runs to the right, or straight up
  std::int8_t half = 0;  // of a circle: +1 upper, -1 lower
};

struct NestedRing {
  Index start;            // its first edge; the last is before the start of the next ring
  Index inside, outside;  // the faces on its left and right, 0 the unbounded one
  bool outer;             // it runs counter-clockwise, round its inside
};

/// The rings that bound one face: bounded, its outer ring first, or unbounded.
std::vector<NestedRing> rings_of_one_face(std::span<const Index> starts, bool unbounded = false);
/// Of any number of faces.
std::vector<NestedRing> nested_rings(const exact::Geometry& geometry, std::span<const RingEdge> edges,
                                     std::span<const Index> starts);

struct RingMarks {
  Mark inside, on, outside;
};

/// The vertices and edges in the order of the ring edges, with the whole geometry. `unbounded`: the unbounded face is
/// inside.
CellComplex ring_complex(exact::Geometry&& geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                         RingMarks marks, bool unbounded = false);

/// The same without the points and supporting curves that no ring uses.
CellComplex ring_map(exact::Geometry&& geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                     RingMarks marks, bool unbounded = false);

inline constexpr RingMarks kOpenSetSigns{-1, 0, 1};

}  // namespace findspace::plane
