// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Contours on the grid: arcs built so that both ends lie exactly on their circle, and rings checked to be what they
// claim to be. A set of rings stands for the closed set between the outer ring and the holes; it is valid when
//   * every ring is a simple closed curve: no two of its edges share a point but the vertex between neighbours;
//   * no two rings share a point, every hole is inside the outer ring and no hole inside another.
// Valid sets are normalised: outer ring counter-clockwise, holes clockwise, no repeated points; collinear points stay.
//
// Guarantee: exact. Pairs of segments are decided in 128-bit integers, arcs in double intervals and where those do not
// decide in exact reals. Cost: O(n log n + pairs of edges whose boxes meet); 3,000 vertices take a few milliseconds.
// Keywords: polygon validation, simple polygon, self-intersection, orientation, even-odd nesting, bulge.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/contour/shape.h"

namespace findspace::plane {

/// The arc edge from `from` to `to` (different points) with the given radius > 0 in grid steps; `large` takes the
/// longer way round. The centre is the midpoint +- perpendicular * sqrt(r^2/d^2 - 1/4), exactly; where the ends are
/// further apart than 2r the radius grows to d/2 (the rule of SVG), and `grown` is set if not null.
ContourEdge radius_arc(GridPoint from, GridPoint to, const exact::Real& radius, bool large, bool ccw,
                       bool* grown = nullptr);

/// The arc edge from `from` to `to` (different points) with bulge tan(angle/4) != 0, counter-clockwise where positive,
/// as in DXF. Where a grid point within one step of the exact centre is equally far from both ends it becomes the
/// centre (bulges are written with few digits); `moved` is set if not null.
ContourEdge bulge_arc(GridPoint from, GridPoint to, const exact::Real& bulge, bool* moved = nullptr);

/// The arc edge from `from` to `to` about the grid point `center`, to which both are equally far.
ContourEdge center_arc(GridPoint from, GridPoint to, GridPoint center, bool ccw);

/// The arc edge from `from` to `to` through `through` (three different points): a segment where they are on one line.
/// The centre is snapped as in bulge_arc.
ContourEdge three_point_arc(GridPoint from, GridPoint through, GridPoint to, bool* moved = nullptr);

/// A ring of two half circles about `center` with radius `radius` grid steps, counter-clockwise.
Contour circle_ring(GridPoint center, std::int64_t radius);

/// Where edge k of a closed ring ends.
inline GridPoint end_of(const Contour& ring, std::size_t k) { return ring[k + 1 == ring.size() ? 0 : k + 1].start; }

/// Distance from the middle of an arc to its chord, in grid steps; `to` is its end.
double sagitta(const ContourEdge& edge, GridPoint to);

struct RingSet {
  std::vector<Contour> contours;     // the outer ring, then the holes
  std::int64_t repeated_points = 0;  // dropped
  std::int64_t reversed_rings = 0;   // given the other direction
};

/// Checks and normalises one outer ring and its holes. Throws Error(kGeometry) that names the ring, both edges and the
/// point; vertices and edges count from 0 as given, edge i starts at vertex i. `step`: size of a grid step in messages.
RingSet make_rings(std::vector<Contour> rings, double step);

/// Rings in any order, none touching another: even-odd nesting sorts them into outer rings and their holes.
std::vector<RingSet> nest_rings(std::vector<Contour> rings, double step);

/// An open chain without its repeated points; `repeated` counts them. Throws Error(kGeometry) if fewer than two
/// points are left. A chain may cross itself: it is a set of points like any other.
Contour make_chain(Contour chain, std::int64_t& repeated);

/// The same closed curve the other way round.
Contour reversed(const Contour& ring);

/// +1 where the valid ring runs counter-clockwise, -1 otherwise.
int orientation(const Contour& ring);

/// Whether `point`, which is not on the ring, is enclosed by it.
bool encloses(const Contour& ring, GridPoint point);

}  // namespace findspace::plane
