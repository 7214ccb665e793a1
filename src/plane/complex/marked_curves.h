// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A marked complex from its curves: x-monotone pieces with the marks on and on both sides of them, and points with
// their marks. For sets whose curves are known (a moved set, a hull), where no labels have to be spread from operands.
//
// Guarantee: exact; curves that cross or touch where they should not, or whose sides disagree on a face, are found and
// decided. Cost: one arrangement. Keywords: validity, planar map construction.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "plane/complex/arrangement.h"
#include "plane/complex/cell_complex.h"
#include "plane/complex/piece_builder.h"

namespace findspace::plane {

/// About where curves do what they should not.
struct CurveFault {
  double x = 0, y = 0;
};

class MarkedCurves {
 public:
  /// Marks of a directed curve: on it, and to its left and right.
  struct Sides {
    Mark on = 0, left = 0, right = 0;
  };

  explicit MarkedCurves(Mark far_away) : far_away_(far_away) {}

  PieceBuilder curves;

  /// Every piece added to `curves` since the last call gets these marks.
  void mark(const Sides& sides);
  /// An end of curves; other ends (where a circle was cut) carry the mark of their curve.
  void add_vertex(Index point, Mark mark) { vertices_.push_back({point, mark}); }
  void add_isolated(Index point, Mark mark, Mark around) { isolated_.push_back({{point, mark}, around}); }

  /// The complex, or the place of a fault: two points that coincide, a curve through a point or another curve, a face
  /// whose marks disagree.
  std::variant<CellComplex, CurveFault> complex() &&;

 private:
  struct MarkedPoint {
    Index point;
    Mark mark;
  };
  struct Isolated {
    MarkedPoint at;
    Mark around;
  };

  std::optional<CurveFault> mark_cells(const Arrangement& a, Marks& marks) const;

  Mark far_away_;
  std::vector<Sides> sides_;  // per piece, for its direction from p0 to p1
  std::vector<MarkedPoint> vertices_;
  std::vector<Isolated> isolated_;
};

}  // namespace findspace::plane
