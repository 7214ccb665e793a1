// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The planar case: convex polygons on the grid and their Phi-function, by the same construction one dimension lower.
// The frontier of P - Q = {p - q} is the merge by angle of the edges of P and of the reflected Q; each of its edges
// comes from an edge of P and a vertex of Q (EV), a vertex and an edge (VE) or two edges (EE). One of the two may be a
// point, the core of a disc. Guarantee: edges, lines (integer, coprime normals) and sign() are exact; values carry the
// roundings of a few double operations. Cost: O(n + m) to build. Source: phi.md 5 and 7. Keywords: no-fit polygon,
// Minkowski difference.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "space/polytope/polytope.h"

namespace findspace::space {

/// A point of the plane in grid steps; |coordinate| <= 2^40.
struct Point2 {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const Point2&, const Point2&) = default;
};

struct Vector2 {
  double x = 0, y = 0;
};

/// Counter-clockwise, strictly convex, with interior, from the lexicographically least vertex on; or one point.
class ConvexPolygon {
 public:
  /// The hull of the points. Throws Error(kGeometry) when they lie on one line, Error(kOutOfRange) beyond the grid.
  static ConvexPolygon hull(std::span<const Point2> points);
  static ConvexPolygon point(const Point2& at);
  std::span<const Point2> vertices() const { return vertices_; }
  bool is_point() const { return vertices_.size() == 1; }

 private:
  std::vector<Point2> vertices_;
};

/// Feature of P, then of Q.
enum class PlanarContact : std::uint8_t { kEV, kVE, kEE };

/// One edge of the frontier of P - Q: it starts at `start`; normal . u + offset <= 0 inside, normal coprime, outward.
struct PlanarEdge {
  Point2 start;
  Point2 normal;
  int128 offset = 0;
  PlanarContact contact = PlanarContact::kEV;
  int feature_p = 0, feature_q = 0;  // a vertex, or an edge by its first vertex
};

class PlanarPhi {
 public:
  /// Not of two points.
  PlanarPhi(const ConvexPolygon& p, const ConvexPolygon& q);
  std::span<const PlanarEdge> edges() const { return edges_; }  // counter-clockwise

  double max_form(const Vector2& u) const;
  double normalised(const Vector2& u) const;
  int sign(const Vector2& u) const;  // exact
  Vector2 gradient(const Vector2& u) const;

  /// Of one edge: the signed distance to its line, and its outward normal of length 1.
  double value(int e, const Vector2& u) const;
  const Vector2& unit_normal(int e) const { return unit_normals_[e]; }
  /// Of a value, with tolerance for a position that was itself rounded.
  double error_bound(const Vector2& u) const;

 private:
  int highest(const Vector2& u, double& value) const;

  std::vector<PlanarEdge> edges_;
  std::vector<Vector2> unit_normals_;
  std::vector<double> offsets_;
  double reach_ = 0;
};

}  // namespace findspace::space
