// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Point sets of space with axis-parallel faces, and sign maps over them: a product grid of coordinates cuts space into
// open boxes, open faces, open edges and vertices, and every one of these cells carries a mark. A set has the marks 0
// and 1, a sign map -1, 0 and +1. Sheets, lines, single points, slits and open ends are cells like any other
// (distances.md 8.1). Guarantee: exact: coordinates are real numbers, marks are never derived from those of neighbours.
// Cost: a byte a cell, (2n+1)^3 cells for n coordinates an axis; more than kMostCells are not made:
// such a complex is too fine, and so is what is made of one; who shows a result asks checked(). Keywords: cell complex,
// cubical complex, rectilinear polyhedra, box unions, Nef polyhedra.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "exact/number/tried.h"
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

class BoxComplex {
 public:
  static constexpr std::size_t kMostCells = std::size_t{1} << 27;

  /// Everywhere `mark`.
  explicit BoxComplex(Axes at = {}, Mark mark = 0);
  /// With a mark for every cell, in the order of index().
  BoxComplex(Axes at, std::vector<Mark> marks);
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
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells(1)) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(cells(0)) +
           static_cast<std::size_t>(x);
  }
  Mark mark(int x, int y, int z) const { return marks_[index(x, y, z)]; }
  Mark mark(const RealVector& p) const;
  std::span<const Mark> marks() const { return marks_; }
  /// The cell along axis k that holds the coordinate.
  int cell_of(int k, const exact::Real& c) const;
  /// The cells from `from` to `to` along axis k, as an interval.
  Interval interval(int k, int from, int to) const;

  void paint(const IntervalBox& box, Mark mark);
  void set_mark(int x, int y, int z, Mark mark) { marks_[index(x, y, z)] = mark; }

  /// The same marks on a grid with no more coordinates than they need.
  BoxComplex simplified() const;
  /// Each mark replaced.
  BoxComplex remarked(const std::function<Mark(Mark)>& to) const;

  /// The cells with marks other than 0 as disjoint boxes.
  std::vector<IntervalBox> boxes() const;
  bool empty() const;

 private:
  std::array<int, 2> range(int k, const Interval& i) const;

  Axes at_;
  std::vector<Mark> marks_;
  bool too_fine_ = false;
};

/// Ascending, each number once.
void sort_axis(Axis& axis);

}  // namespace findspace::space
