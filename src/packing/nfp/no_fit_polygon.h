// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The no-fit polygon of two parts in doubles: the boundary of the positions p at which the interiors of A and B + p
// meet. Slits and single points where B fits into A without clearance are kept as edges with the overlap on both sides.
// Guarantee: the set is the exact contact map of the kernel, its vertices are rounded once. It steers the search;
// proofs do not use it. Cost: one Minkowski sum. Source: docs/decisions/0002, 0008. Keywords: NFP, configuration space.
#pragma once

#include <vector>

#include "packing/problem/problem.h"
#include "plane/complex/cell_complex.h"

namespace findspace::packing {

struct Vec {
  double x = 0, y = 0;

  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
};

inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }

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
  std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> rings;
  double step = 1;
};

/// The shape on the problem's grid, or on a coarser one where that has too many digits.
SearchShape search_shape(const Polygon& shape, int digits);

/// The shape as a closed set on its grid.
plane::Region region_of(const SearchShape& shape);

/// Where conditions of the two parts hold, in steps of their grid, and how far positions can be from there, in units.
struct Tie {
  std::vector<plane::Region> regions;
  double reach = 0;
};

/// In units. Both shapes are on one grid. With a gap the positions where B + p is nearer to A are in it too: A is grown
/// by a polygon of 32 sides about the disc of the gap, so no more than half a per cent of the gap is given away. With a
/// tie all positions where a condition does not hold are in it; arcs become chords and tangents on its side, 32 a
/// circle.
NoFitPolygon no_fit_polygon(const SearchShape& a, const SearchShape& b, double gap, const Tie* tie = nullptr);

}  // namespace findspace::packing
