// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The elementary parts of a closed set's boundary: vertices, segments and arcs, as numbers for search and as exact
// level curves for decisions. Guarantee: numbers are right to about 1e-15 of the coordinates; level curves are exact.
// Keywords: features, features.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "distance/planar_features/level_curve.h"
#include "plane/complex/cell_complex.h"
#include "plane/query/locate.h"

namespace findspace::distance {

/// A middle of the enclosure that a real number carries.
double near_value(const exact::Real& r);

/// As std::hypot for coordinates whose squares doubles hold, at a tenth of its cost.
inline double plain_length(double x, double y) { return std::sqrt(x * x + y * y); }

/// A vertex, or the relatively open inside of an edge.
struct BoundaryFeature {
  plane::Cell cell;
  bool arc = false;
  std::int8_t half = 0;          // arc: +1 upper, -1 lower half of its circle
  double x0 = 0, y0 = 0;         // first end, or the vertex
  double x1 = 0, y1 = 0;         // second end
  double cx = 0, cy = 0, r = 0;  // circle of an arc

  bool is_vertex() const { return cell.dimension == 0; }
  /// Of the closed feature.
  double distance(double x, double y) const { return arc ? arc_distance(x, y) : std::sqrt(squared(x, y)); }
  double squared_distance(double x, double y) const {
    const double d = arc ? arc_distance(x, y) : 0;
    return arc ? d * d : squared(x, y);
  }
  /// The greatest distance of a point of the closed feature; of a segment that of an end.
  double farthest(double x, double y) const;
  /// The nearest point lies inside the edge (always for a vertex), or no farther than `slack` beyond an end.
  bool faces(double x, double y, double slack = 0) const;
  /// An arc's point in the direction (dx, dy) from its centre lies on it, or the direction passes its end within
  /// `slack`.
  bool has_direction(double dx, double dy, double slack = 0) const;

 private:
  double arc_distance(double x, double y) const;
  /// Of a vertex or a segment.
  double squared(double x, double y) const {
    const double px = x - x0, py = y - y0, dx = x1 - x0, dy = y1 - y0, t = px * dx + py * dy;
    if (t <= 0) return px * px + py * py;
    const double size = dx * dx + dy * dy, qx = x - x1, qy = y - y1, area = px * dy - py * dx;
    return t < size ? area * area / size : qx * qx + qy * qy;
  }
};

BoundaryFeature vertex_feature(const plane::CellComplex& c, plane::Index v);
BoundaryFeature edge_feature(const plane::CellComplex& c, plane::Index e);
/// Of all vertices and edges whose mark is wanted.
std::vector<BoundaryFeature> features(const plane::CellComplex& c, const std::function<bool(plane::Mark)>& wanted);

/// Where the distance to the feature, seen from (x, y), is sign * level (sign +1 or -1).
LevelCurve near_level_curve(const plane::CellComplex& c, const BoundaryFeature& s, double x, double y, int sign);
/// Where the distance to the edge is `level` on its left, or right, as it runs from its first end.
LevelCurve level_curve_beside(const plane::CellComplex& c, plane::Index edge, bool left);
/// Where the greatest distance to the vertex or arc is `level`.
LevelCurve far_level_curve(const plane::CellComplex& c, const BoundaryFeature& s);
/// A curve that keeps still: the line or circle of an edge, the place of a vertex (a circle of radius 0).
LevelCurve fixed_level_curve(const plane::CellComplex& c, const BoundaryFeature& s);

}  // namespace findspace::distance
