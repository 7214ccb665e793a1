// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The marks of a complex at many points, in doubles where these decide: a lattice of buckets over the complex, most of
// them within one face. Guarantee: a mark that is given is that of every point within the stated error; nothing where
// doubles leave it open (on or beside an edge that is no line of the grid), for the exact Locator. Method: a bucket
// that no edge enters holds its mark; elsewhere a ray upwards, a little to the right of the point, finds the lowest
// edge above it, bucket by bucket. Cost: building O(n) and some three buckets an edge; a query about 10 ns in a bucket
// of one face, 50 ns beside edges. Threads: safe, nothing changes. Source: the bucket method of Asano, Edahiro, Imai,
// Iri and Murota (1985). Keywords: point location, point in polygon, batched queries, uniform grid.
#pragma once

#include <optional>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

class MarkGrid {
 public:
  explicit MarkGrid(const CellComplex& complex);

  /// A point in grid steps, off by at most `error` in each coordinate; with error 0 it is exactly this one.
  struct Query {
    double x, y, error;
  };
  std::optional<Mark> mark(const Query& q) const;

 private:
  /// An edge or an isolated vertex in doubles.
  struct Item {
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
    Index line = kNone;  // in lines_
  };
  struct GridLine {
    std::int64_t a, b;
    exact::int128 c;
  };
  struct Box {
    double x0, x1, y0, y1;
  };
  struct Range {
    double low, high;
  };
  enum class Side : std::uint8_t { kBeside, kBelow, kAbove, kOn, kOpen };
  /// What one bucket tells: nothing, a mark, or that doubles do not decide.
  struct Look {
    bool open = false;
    std::optional<Mark> mark;
  };

  void add_edge(const CellComplex& c, Index edge);
  void add_vertex(const CellComplex& c, Index vertex);
  static Box box(const Item& item);
  void fit();
  void set_error(Item& item) const;
  Index column(double x) const;
  Index row(double y) const;
  Box strip(const Item& item, Index column) const;
  template <class Visit>
  void each_bucket(const Item& item, Visit visit) const;
  void fill();
  void settle(const CellComplex& c);

  Side side(const Item& item, const Query& q) const;
  Side line_side(const Item& item, const Query& q) const;
  static Side arc_side(const Item& item, const Query& q);
  static Side vertical_side(const Item& item, const Query& q);
  Range height(const Item& item, double x, double error) const;
  static bool steeper(const Item& first, const Item& second);
  Look look(std::size_t bucket, double top, const Query& q) const;
  std::optional<Mark> climb(Index column, Index row, const Query& q) const;

  std::vector<Item> items_;
  std::vector<GridLine> lines_;  // those of the grid, for grid points
  Mark outside_ = 0;
  double left_ = 0, bottom_ = 0, right_ = 0, top_ = 0, largest_ = 0;
  double slack_ = 0;  // items are listed in buckets that they are as near to
  double width_ = 1, height_ = 1;
  Index columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> start_;  // of a bucket: where its items begin; below 0 it lies in one face
  std::vector<Index> listed_;        // bucket after bucket, each ended by kNone
};

}  // namespace findspace::plane
