// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Convex sets whose union is the closure of the complement of a body. Its parts have no radius; a single one may be
// flat, several may be points. The first ones are half spaces; the others, cells of the bounding box, do not meet in
// their interiors. Of what is a mesh they are the empty cells of the partition that made its parts, so they leave the
// mesh itself, also where parts were rounded to the grid: a shape may then protrude from the rounded parts by `moved`
// and fit all the same. Between other rounded parts there may be cracks, up to twice `moved` wide, where they touched.
// Cells so thin leave out what is as near to those parts, so such a body has no slot of its own of that width either.
// Guarantee: exact, but for that. Cost: of one mesh none; else a cell of the box is cut by every part, and by the cells
// of every mesh, that it overlaps. Keywords: complement, convex decomposition.
#pragma once

#include <vector>

#include "space/body/body.h"
#include "space/polytope/extent.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

struct OutsideCell {
  std::vector<HalfSpace> planes;        // all <= 0
  std::vector<RealVector> vertices;     // none for a half space
  std::vector<std::vector<int>> tight;  // the planes each of them lies on

  bool bounded() const { return !vertices.empty(); }
};
std::vector<OutsideCell> outside_cells(const Body& body);

Extent extent_of(const OutsideCell& bounded);
/// Whether the two vertices are on one edge.
bool share_edge(const OutsideCell& cell, std::size_t v, std::size_t w);
/// Of the edges of a bounded cell.
std::vector<RealVector> edge_directions(const OutsideCell& cell);

}  // namespace findspace::space
