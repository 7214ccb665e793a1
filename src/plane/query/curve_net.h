// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary curves of a complex as people think of them, for writing: the x-monotone pieces of one circle joined to
// one arc, a whole circle to one closed curve; with coordinates as doubles in the scene's unit. A vertex disappears
// where it only joins two pieces of one circle that carry its mark. Guarantee: curves meet at vertices only; every
// piece belongs to one curve. Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "plane/query/measure_cells.h"
#include "plane/query/summary.h"

namespace findspace::plane {

class CurveNet {
 public:
  /// A segment, an arc (counter-clockwise) or a whole circle (from == to).
  struct Curve {
    Index from = 0, to = 0;     // vertices of the complex
    Index first = 0, last = 0;  // half-edges, in the direction of travel
    Mark mark = 0;
    bool arc = false;
    Place center{};  // of an arc
    double radius = 0;
  };

  /// A curve as part of a ring: which, and whether it is travelled from `from` to `to`.
  struct Side {
    Index curve = 0;
    bool forward = true;
  };
  using Ring = std::vector<Side>;

  /// Keeps a reference to the complex. `step`: one grid step in the unit of the results.
  CurveNet(const CellComplex& c, const exact::Real& step);

  const CellComplex& complex() const { return c_; }
  const std::vector<Curve>& curves() const { return curves_; }
  /// The one that an edge is a piece of.
  const Curve& curve_of(Index edge) const { return curves_[curve_of_edge_[edge]]; }
  /// Its pieces, in the direction of travel.
  std::vector<Index> half_edges(const Curve& curve) const;
  /// That an arc spans, in (0, 2 pi].
  double angle(const Curve& arc) const;
  /// The vertices that are left, and the place of each vertex of the complex among them (kNone: it disappeared).
  const std::vector<Index>& vertices() const { return vertices_; }
  Index number(Index vertex) const { return number_[vertex]; }
  Place at(Index vertex) const { return {scaled(measures_.x(vertex)), scaled(measures_.y(vertex))}; }
  /// The boundary cycle a half-edge belongs to, the face on its left.
  Ring ring(Index half_edge) const;
  /// The same for any closed chain of half-edges that turns off at vertices that are left only.
  Ring ring(std::span<const Index> half_edges) const;
  double scaled(const Twofold& steps) const { return (steps * step_).value(); }
  /// The leftmost, rightmost, highest and lowest points of its circle that lie inside an arc, in its direction: they
  /// are grid points where the circle is one of the grid.
  std::vector<Place> extremes(const Curve& arc) const;
  /// Extent of a curve, with the extreme points of its arcs.
  Bounds bounds(const Curve& curve) const;

 private:
  void find_joints();
  void add_curve(Index first);
  bool is_start(Index half_edge) const;
  Index preferred(Index edge) const;

  const CellComplex& c_;
  Twofold step_;
  CellMeasures measures_;
  std::vector<char> joint_;
  std::vector<Curve> curves_;
  std::vector<Index> curve_of_edge_, vertices_, number_;
};

}  // namespace findspace::plane
