// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary of one face in doubles, for choosing a good place in it. Nothing here is relied on: what is chosen is
// proved with exact predicates afterwards.
#pragma once

#include <span>
#include <vector>

#include "plane/query/measure_cells.h"

namespace findspace::plane {

class FaceOutline {
 public:
  struct Spot {
    double x = 0, y = 0, clearance = -1;  // distance to the boundary; negative: no spot
  };

  FaceOutline(const CellComplex& c, const CellMeasures& measures, Index face, std::span<const Index> half_edges);

  /// The place with the most clearance among those looked at.
  Spot clearest() const;
  double clearance(double x, double y) const;

 private:
  struct Curve {
    double x0, y0, x1, y1;
    double cx, cy, r;  // r < 0: a segment
    int half;
    bool face_above, face_below;
  };
  struct Crossing {
    double y;
    bool face_above, face_below;
  };
  void add(const CellComplex& c, const CellMeasures& measures, Index edge, Index face);
  void set_frame();
  Spot widest_gap(double x) const;
  Spot climb(Spot from, int steps) const;

  std::vector<Curve> curves_;
  std::vector<std::array<double, 2>> points_;  // isolated vertices
  bool unbounded_;
  double x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0;  // where to look
};

}  // namespace findspace::plane
