// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A closed chain in doubles: its area, its length, what it goes round and how far away it is. No guarantee but that of
// rounding: whoever uses the answers leaves room for it. Cost: linear. Keywords: shoelace formula.
#pragma once

#include <vector>

#include "plane/complex/extent.h"

namespace findspace::plane {

class RingSketch {
 public:
  /// Of one edge at least.
  explicit RingSketch(const Contour& ring);

  /// Without the whole circles of its arcs.
  const PieceBox& box() const { return box_; }
  /// In square grid steps, positive where it runs counter-clockwise.
  double area() const;
  double length() const;
  /// By a ray to the right, as `encloses` does exactly.
  bool goes_round(double x, double y) const;
  /// No more than the distance of the place from the ring.
  double apart(double x, double y) const;

 private:
  struct Side {
    double x, y, u, v;                                 // from, to
    double cx = 0, cy = 0, r = 0, turn = 0, rise = 0;  // of an arc; r = 0 for a segment
  };

  std::vector<Side> sides_;
  PieceBox box_{};
};

}  // namespace findspace::plane
