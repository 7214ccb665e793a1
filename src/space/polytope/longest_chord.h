// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The longest segments of a direction in a convex polytope with interior. Their length, as a function of the line, is
// concave and linear between the edges that the line meets, so one is at a vertex, or at two edges that cross seen
// along the direction. Of the polytope grown by a ball: as far as the direction leaves the differences of two of its
// points grown by twice the radius, so the farthest exit from the balls, cylinders and slabs about differences of its
// vertices, edges and facets; of a set of any dimension. Guarantee: exact. Cost: for each pair of edges some exact
// signs; Error(kUnsupported) beyond kMostPairs. Keywords: width in a direction, difference body, gauge.
#pragma once

#include <cstddef>

#include "space/polytope/convex_region.h"

namespace findspace::space {

inline constexpr std::size_t kMostPairs = 100000;

struct LongestChord {
  exact::Real length;   // in lengths of the direction
  RealVector middle;    // of one of them; if not `inside`, of one that is in a facet
  bool inside = false;  // some run through the interior
};

LongestChord longest_chord(const ConvexRegion& region, const RealVector& direction);
/// Of the set grown by a ball; radius > 0. The one found is inside.
LongestChord longest_chord(const ConvexRegion& set, const exact::Real& radius, const RealVector& direction);

}  // namespace findspace::space
