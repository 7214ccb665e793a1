// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The no-fit polygon of two parts in doubles: the boundary of the positions p at which the interiors of A and B + p
// meet. Slits and single points where B fits into A without clearance are kept as edges with the overlap on both sides.
// Arcs of round parts become sides last of all. Guarantee: the set is the exact contact map of the kernel, its vertices
// are rounded once. It steers the search;
// proofs do not use it. Cost: one Minkowski sum. Source: docs/decisions/0002, 0008. Keywords: NFP, configuration space.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "packing/problem/problem.h"
#include "packing/problem/vec.h"
#include "plane/complex/shared_region.h"

namespace findspace::packing {

/// An edge with the overlap on its left; of a slit on both sides.
struct NoFitEdge {
  Vec from, to;
  bool slit = false;
};

struct NoFitPolygon {
  std::vector<NoFitEdge> edges;
  Vec low, high;  // its box
};

/// A part as the search sees it: on a grid that machine integers hold, `step` units a grid step.
struct SearchShape {
  std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> rings;  // of a round part about it
  double step = 1;
  std::optional<plane::SharedRegion> round = {};  // the part itself
};

/// The shape on the problem's grid, or on a coarser one where that has too many digits and no part is round.
SearchShape search_shape(const Problem& problem, const Polygon& shape);
SearchShape search_shape(const Problem& problem, const Part& part, const Fraction& angle, bool mirrored);

/// The shape as a closed set on its grid.
plane::SharedRegion region_of(const SearchShape& shape);

/// Where conditions of the two parts hold, in steps of their grid, and how far positions can be from there, in units.
struct Tie {
  std::vector<plane::Region> regions;
  double reach = 0;
};

/// In units. Both shapes are on one grid. With a gap the positions where B + p is nearer to A are in it too: A is grown
/// by a polygon of 32 sides about the disc of the gap, so no more than half a per cent of the gap is given away; round
/// parts by the disc itself. With a tie all positions where a condition does not hold are in it. Arcs become chords and
/// tangents on its side (arc_corners.h).
NoFitPolygon no_fit_polygon(const SearchShape& a, const SearchShape& b, double gap, const Tie* tie = nullptr);

}  // namespace findspace::packing
