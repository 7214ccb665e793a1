// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary of a set as segments and arcs with exact real ends, relative to a centre of rotation, so that the set
// can be rotated by any exact angle; and where two such edges meet. Arcs run counter-clockwise and measure at most 180
// degrees. Guarantee: exact. Cost: a few exact operations an edge, a few dozen a pair that meets.
#pragma once

#include <utility>
#include <vector>

#include "exact/planar/angle.h"
#include "plane/base/real_vector.h"
#include "plane/complex/cell_complex.h"
#include "plane/rotation/rough_point.h"

namespace findspace::plane {

/// The relatively open edge from p to q.
struct RotatedEdge {
  RealVector p, q;
  bool arc = false;
  RealVector center;
  exact::Real radius;
  Index cell = 0;        // the edge of the complex
  Index v0 = 0, v1 = 0;  // the vertices of the complex at p and q
};

struct RoughBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool apart(const RoughBox& b) const { return x1 < b.x0 || b.x1 < x0 || y1 < b.y0 || b.y1 < y0; }
  bool apart(double x, double y) const { return x < x0 || x > x1 || y < y0 || y > y1; }
};

inline bool is_any(Mark) { return true; }

/// All vertices and the edges with wanted marks of a complex, moved by -about. Edges, and vertices on the grid, are
/// made when they are asked for: all of them would take 400 bytes a vertex. The complex must outlive it.
class RotatedNet {
 public:
  RotatedNet(const CellComplex& complex, exact::RealPoint about, bool (*wanted)(Mark) = is_any);

  Index vertex_count() const { return Index(complex_.vertices.size()); }
  const std::vector<Index>& edges() const { return edges_; }
  /// By their places in the complex.
  RealVector vertex(Index v) const;
  RotatedEdge edge(Index e) const;

 private:
  const CellComplex& complex_;
  exact::RealPoint about_;
  std::vector<Index> edges_;
  std::vector<RealVector> off_grid_;  // vertices that take long to make
  std::vector<Index> place_;          // of a vertex among them; empty where there are none
};

/// A double near the number; within a few ulps of the largest coordinates it is made of.
double rough(const exact::Real& r);
inline RoughPoint rough(const RealVector& p) { return {rough(p.x), rough(p.y)}; }
/// Contains the edge.
RoughBox box_of(const RotatedEdge& e);

/// Sign of the place of a point of the edge's line or circle: + inside the edge, 0 at an end, - outside.
int place_on(const RotatedEdge& e, const RealVector& point);
/// Whether the point lies on the open edge.
bool lies_on(const RotatedEdge& e, const RealVector& point);
/// The points inside both edges where they cross or touch; none for edges of one line or one circle.
std::vector<RealVector> meetings(const RotatedEdge& e, const RotatedEdge& f);
/// Order of two points of the edge from p to q.
int compare_along(const RotatedEdge& e, const RealVector& s, const RealVector& t);
/// A point of the edge strictly between two of its points, or its ends.
RealVector point_between(const RotatedEdge& e, const RealVector& s, const RealVector& t);

}  // namespace findspace::plane
