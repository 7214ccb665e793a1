// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The topological operators on exact point sets of the plane, plain (not regularised). With star(c) the set of cells
// whose closure contains the cell c, c itself included (so a vertex sees the faces around it directly):
//     interior    int S  = cells c whose whole star belongs to S
//     closure     cl S   = cells c with some cell of the star in S
//     boundary    bd S   = cl S minus int S
//     regularize  reg S  = cl(int S), not int(cl S)
//     complement         = R^2 minus S
// Every operator keeps the cells and sets new marks; cells that agree are then merged. Guarantee: exact, no coordinate
// is looked at. Cost: linear in the cells. Source: distances.md 8.1; Requicha 1980 for regularisation.
// Keywords: open set, closed set, regular set, whisker, crack, puncture.
#pragma once

#include <algorithm>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

Region interior(Region s);
Region closure(Region s);
Region boundary(Region s);
Region regularize(Region s);
Region complement(Region s);

/// interior(s) = s. The empty set and the plane are open and closed.
bool is_open(const Region& s);
/// closure(s) = s.
bool is_closed(const Region& s);
/// regularize(s) = s: a regular closed set. The empty set is one.
bool is_regular(const Region& s);
bool is_empty(const Region& s);
/// s is the plane.
bool is_whole(const Region& s);
bool is_bounded(const Region& s);

/// Whether a face, edge or vertex has a mark for which `is(mark)`.
template <class Is>
bool any_mark(const CellComplex& c, Is is) {
  const auto cell = [&](const auto& x) { return is(x.mark); };
  return std::any_of(c.faces.begin(), c.faces.end(), cell) || std::any_of(c.edges.begin(), c.edges.end(), cell) ||
         std::any_of(c.vertices.begin(), c.vertices.end(), cell);
}

bool has_mark(const CellComplex& c, Mark wanted);

/// The least and the greatest mark in the star of every edge and vertex: with marks 0/1 those of the interior and of
/// the closure.
struct StarMarks {
  std::vector<Mark> edge_least, edge_greatest, vertex_least, vertex_greatest;
};
StarMarks star_marks(const CellComplex& c);

}  // namespace findspace::plane
