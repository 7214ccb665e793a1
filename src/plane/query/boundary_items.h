// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The edges and isolated vertices of a complex in doubles, each with the marks on it and beside it: on which side of
// one a point lies, and between which heights it runs. Guarantee: every answer holds for all points within the error
// that the question states; `kOpen` where doubles leave it open. Points of the grid and lines of the grid are compared
// in integers then. Cost: 10 ns a question. Keywords: point-line orientation, floating-point filter.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// A point in grid steps, off by at most `error` in each coordinate; with error 0 it is exactly this one.
struct BlurredPoint {
  double x, y, error;
};

/// An edge or an isolated vertex in doubles.
struct BoundaryItem {
  enum class Kind : std::uint8_t { kLine, kArc, kVertical };
  double x0 = 0, x1 = 0, end_error0 = 0, end_error1 = 0;  // its ends from left to right
  double y0 = 0, y1 = 0;
  double a = 0, b = 0, c = 0;  // line: unit normal with b > 0, and offset; arc: centre and radius
  double c_error = 0;
  double error = 0;  // line: of a x + b y - c in the box; arc: of x - a and of y - b
  double steep = 0;  // line: by how much it rises a unit
  Kind kind = Kind::kLine;
  bool upper = false;  // half of the circle
  Mark mark = 0, below = 0, above = 0, mark0 = 0, mark1 = 0;
  Index line = kNone;  // of those of the grid
};

class BoundaryItems {
 public:
  explicit BoundaryItems(const CellComplex& complex);

  const std::vector<BoundaryItem>& all() const { return items_; }
  struct Box {
    double x0, x1, y0, y1;
  };
  /// Encloses all items, and what lies as near to them as `slack`.
  const Box& bounds() const { return bounds_; }
  /// Within it doubles may take a place for another.
  double slack() const { return slack_; }

  /// Encloses the part of an item between these x.
  Box part(const BoundaryItem& item, double from, double to) const;
  struct Heights {
    double low, high;
  };
  /// Those of an item, not vertical, where x is off by at most `error`.
  Heights heights(const BoundaryItem& item, double x, double error) const;
  enum class Side : std::uint8_t { kBeside, kBelow, kAbove, kOn, kOpen };
  /// Where the point lies from an item; of an end that is exact a ray upwards runs to its right.
  Side side(const BoundaryItem& item, const BlurredPoint& p) const;

 private:
  struct GridLine {
    std::int64_t a, b;
    exact::int128 c;
  };

  void add_edge(const CellComplex& c, Index edge);
  void add_vertex(const CellComplex& c, Index vertex);
  void enclose();
  void set_error(BoundaryItem& item) const;
  Side line_side(const BoundaryItem& item, const BlurredPoint& p) const;

  std::vector<BoundaryItem> items_;
  std::vector<GridLine> lines_;  // those of the grid, for grid points
  Box bounds_{0, 0, 0, 0};
  double largest_ = 0, slack_ = 0;
};

}  // namespace findspace::plane
