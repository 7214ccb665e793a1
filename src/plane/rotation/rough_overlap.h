// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A filter in doubles: does a closed set B, rotated and moved, certainly meet an open set O? Witnesses are a point of
// B's boundary well inside O, a point of O's boundary well inside B, or two edges that cross well inside both.
// Guarantee: a yes is right (every margin is a million times what doubles lose); a no says nothing, so what it lets
// through is decided exactly elsewhere. Cost: pairs of edges, some nanoseconds each. Keywords: floating point filter,
// collision.
#pragma once

#include <functional>
#include <vector>

#include "plane/rotation/rotated_edges.h"
#include "plane/rotation/rough_point.h"

namespace findspace::plane {

/// The boundary of a set of faces ("inside") in doubles; inside or dangling curves as well.
class RoughSet {
 public:
  RoughSet(const CellComplex& complex, const exact::RealPoint& about, const std::function<bool(Mark)>& inside);

  struct Line {
    RoughPoint p, q, center;
    double radius = 0;                       // of an arc, counter-clockwise from p to q
    bool separates = false, bounds = false;  // one side, at least one side is inside
  };

  /// Rotated by the unit number.
  RoughSet rotated(RoughPoint by) const;
  /// Inside, at least `tolerance` away from every edge.
  bool contains(RoughPoint at, double tolerance) const;
  const std::vector<Line>& lines() const { return lines_; }
  const std::vector<RoughPoint>& points() const { return points_; }  // ends and middles of the edges, isolated points
  double reach() const;                                              // the greatest distance of an edge from the centre

 private:
  std::vector<Line> lines_;
  std::vector<RoughPoint> points_;
  bool unbounded_ = false;
};

/// Whether B, moved by `by`, certainly meets O. `either_way`: it counts as well where a curve of the other set lies in
/// the inside of B without O beside it.
bool surely_meets(const RoughSet& b, const RoughSet& o, RoughPoint by, bool either_way, double tolerance);

/// A point of B, moved, lies in O, or one of O's boundary in B, farther than `tolerance` from the other's edges.
bool well_inside(const RoughSet& b, const RoughSet& o, RoughPoint by, double tolerance);

}  // namespace findspace::plane
