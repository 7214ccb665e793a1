// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Point sets of space with axis-parallel faces, and sign maps over them: a product grid of coordinates cuts space into
// open boxes, open faces, open edges and vertices, and every one of these cells carries a mark. A set has the marks 0
// and 1, a sign map -1, 0 and +1. Sheets, lines, single points, slits and open ends are cells like any other
// (distances.md 8.1). Guarantee: exact: coordinates are real numbers, marks are never derived from those of neighbours.
// Cost: a bit a cell of a set, two of a sign map, (2n+1)^3 cells for n coordinates an axis; work is by words of bits
// and by runs of equal marks along x. More than kMostCells are not made: such a complex is too fine, and so is what is
// made of one; who shows a result asks checked(). Keywords: cell complex, cubical complex, rectilinear polyhedra, box
// unions, Nef polyhedra.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "exact/number/tried.h"
#include "space/box/cell_bits.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

using Mark = std::int8_t;
using Axis = std::vector<exact::Real>;  // ascending
using Axes = std::array<Axis, 3>;

/// A product of intervals; an end that is none is infinite.
struct Interval {
  std::optional<exact::Real> from, to;
  bool from_in = false, to_in = false;
};
using IntervalBox = std::array<Interval, 3>;
/// First and last cells along each axis.
using CellRange = std::array<std::array<int, 2>, 3>;
/// Cells of one grid by those of another, along each axis; ascending.
using CellNumbers = std::array<std::vector<int>, 3>;

class BoxComplex {
 public:
  static constexpr std::size_t kMostCells = std::size_t{1} << 27;

  /// Everywhere `mark`.
  explicit BoxComplex(Axes at = {}, Mark mark = 0);
  /// A set of the cells of a grid that is not too fine.
  BoxComplex(Axes at, CellBits in);
  /// The union of the boxes (which may be flat), marked 1.
  static BoxComplex of_boxes(std::span<const IntervalBox> boxes);

  /// Whether it would have had more than kMostCells cells: it has no marks that mean something.
  bool too_fine() const { return too_fine_; }
  static BoxComplex without_cells();
  /// What this is for who asked for it: itself, or a refusal where it is too fine.
  exact::Tried<BoxComplex> checked() &&;

  const Axes& at() const { return at_; }
  /// Cells along axis k: the open intervals have even numbers, the coordinates odd ones.
  int cells(int k) const { return 2 * static_cast<int>(at_[k].size()) + 1; }
  std::array<int, 3> cell_counts() const { return {cells(0), cells(1), cells(2)}; }
  Mark mark(int x, int y, int z) const {
    if (!in_.has(x, y, z)) return 0;
    return has_negative() && negative_.has(x, y, z) ? Mark(-1) : Mark(1);
  }
  Mark mark(const RealVector& p) const;
  /// The cells with marks other than 0, and those with a negative one: without bits where there is none.
  const CellBits& in() const { return in_; }
  const CellBits& negative() const { return negative_; }
  /// Where the run of equal marks ends that holds the cell: one beyond.
  int run_end(int x, int y, int z) const;
  /// The cell along axis k that holds the coordinate.
  int cell_of(int k, const exact::Real& c) const;
  /// The cells from `from` to `to` along axis k, as an interval.
  Interval interval(int k, int from, int to) const;

  void paint(const IntervalBox& box, Mark mark);
  void paint(const CellRange& cells, Mark mark);
  /// The cells of a row from `from` to before `to`.
  void mark_run(int y, int z, int from, int to, Mark mark);
  /// The row (y, z) as the one before it, (y - 1, z).
  void repeat_row(int y, int z);

  /// The same marks on a grid with no more coordinates than they need.
  BoxComplex simplified() const;
  /// The same marks in reverse order along every axis, or as they are, with other coordinates, as many.
  BoxComplex reversed(Axes at) const;
  BoxComplex moved_to(Axes at) const;
  /// Each mark replaced.
  BoxComplex remarked(const std::function<Mark(Mark)>& to) const;

  /// The cells with marks other than 0 as disjoint boxes.
  std::vector<IntervalBox> boxes() const;
  /// The same ones by their cells.
  std::vector<CellRange> ranges() const;
  bool empty() const;

 private:
  std::array<int, 2> range(int k, const Interval& i) const;
  bool has_negative() const { return !negative_.words().empty(); }
  std::array<std::vector<char>, 3> needed() const;

  Axes at_;
  CellBits in_, negative_;
  bool too_fine_ = false;
};

/// For every cell along an axis and one beyond: the first cell of the finer (or coarser) grid that lies in it or after
/// it; `from`: the cell here of every cell there.
std::vector<int> first_cells(const std::vector<int>& from, int cells);

/// Ascending, each number once.
void sort_axis(Axis& axis);

}  // namespace findspace::space
