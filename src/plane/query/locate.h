// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The cell that contains a point: vertex, edge or face. Guarantee: exact for every real point.
// Method: a vertical ray upwards from a little to the right of the point (the lowest edge above it has the face below
// it), through a table of columns; the order of two edges above the point is decided at the later of their left ends.
// The geometry of the complex is not copied but for the few cells that a query compares exactly.
// Cost: building O(n) and O(n) memory; a query looks at the edges over its column, a few of them exactly. One point
// alone needs no table: O(n), no memory. Keywords: point location, point in polygon.
#pragma once

#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

struct Cell {
  int dimension = 2;
  Index index = 0;  // in vertices, edges or faces
  friend bool operator==(const Cell&, const Cell&) = default;
};

inline Mark mark_of(const CellComplex& c, Cell cell) {
  return cell.dimension == 2   ? c.faces[cell.index].mark
         : cell.dimension == 1 ? c.edges[cell.index].mark
                               : c.vertices[cell.index].mark;
}

/// A box that encloses an edge or an isolated vertex.
struct CellBox {
  double x0, x1, y0, y1;
  Index cell;  // edge, or edge count + isolated vertex
};

/// Prepared for many points. Keeps a reference to the complex. Threads: safe.
class Locator {
 public:
  explicit Locator(const CellComplex& c);
  Cell locate(const exact::RealPoint& p) const;
  Mark mark(const exact::RealPoint& p) const { return mark_of(c_, locate(p)); }

 private:
  struct Span {
    Index first, last;
  };
  Index column(double x) const;
  Span columns(const CellBox& b) const { return {column(b.x0), column(b.x1)}; }
  void build_columns();

  const CellComplex& c_;
  double left_ = 0, per_width_ = 0;
  std::vector<Index> column_start_;
  std::vector<CellBox> boxes_;
  std::vector<Index> entries_;  // of boxes, column after column
};

/// For one point.
Cell locate(const CellComplex& c, const exact::RealPoint& p);

}  // namespace findspace::plane
