// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary of one face in doubles, for choosing a good place in it. Nothing here is relied on: what is chosen is
// proved with exact predicates afterwards. Cost: the curves of a face are kept where they are few, else made anew each
// time.
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

  /// Keeps references to all of them.
  FaceOutline(const CellComplex& c, const CellMeasures& measures, Index face, std::span<const Index> half_edges);

  /// The place with the most clearance among those looked at.
  Spot clearest() const;

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
  /// Calls f with every curve of the boundary, one with the face on both sides once.
  template <class F>
  void each_curve(F&& f) const;
  Curve curve(Index edge) const;
  static double distance(const Curve& k, double x, double y);
  /// Whether the distance is certainly greater than `than`; no root is taken.
  static bool is_farther(const Curve& k, double x, double y, double than);
  /// Or some number not above `enough`, where it is not above that.
  double clearance(double x, double y, double enough = -1) const;
  void set_frame();
  Spot widest_gap(double x) const;
  Spot climb(Spot from, int steps) const;

  const CellComplex& c_;
  const CellMeasures& measures_;
  Index face_;
  std::span<const Index> half_edges_;
  std::size_t curve_count_ = 0;
  std::vector<Curve> few_;                     // all curves, where they are few
  std::vector<std::array<double, 2>> points_;  // isolated vertices
  double x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0;   // where to look
};

}  // namespace findspace::plane
