// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions of the primitive shapes: rings, discs, points, chains; all closed sets. Guarantee: exact.
#pragma once

#include <span>
#include <vector>

#include "plane/base/arena.h"
#include "plane/complex/cell_complex.h"
#include "plane/complex/ring_map.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// Closed sets, each the one between an outer ring and its holes.
using Polygons = std::span<const std::span<const Contour>>;

/// The curves of valid rings, as they follow each other.
struct RingCurves {
  explicit RingCurves(Memory memory) : edges(memory), rings(memory) {}

  exact::Geometry geometry;
  ArenaVector<RingEdge> edges;
  ArenaVector<NestedRing> rings;  // of every set the outer one first
  bool could_merge = false;       // some that follow each other may be one edge
};
RingCurves ring_curves(Polygons polygons, Memory memory);

/// The closed set between an outer ring (counter-clockwise) and holes (clockwise), validated before (contour.h).
Region region_of_rings(std::span<const Contour> rings);
/// The union of such sets, each given by its rings, whose boxes are apart.
Region region_of_polygons(Polygons polygons);
Region region_of_disc(const exact::Real& cx, const exact::Real& cy, const exact::Real& radius);
Region region_of_points(std::span<const GridPoint> points);
/// An open chain: its edges and vertices, a set without interior. The last edge of the contour is only its end point.
Region region_of_chain(const Contour& chain);

}  // namespace findspace::plane
