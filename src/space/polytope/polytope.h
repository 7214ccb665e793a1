// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A convex polytope with interior whose vertices lie on the grid: the convex hull of finitely many grid points.
// Every factory ends in an exact hull, so duplicates, points inside, points on facets or edges, triangulated facets and
// wrong orientation in the input leave no trace; what was repaired is counted. Flat input is refused, and the message
// says what is flat. Guarantee: exact (phi.md 3, N1 to N6). Cost: O(n log n) expected for n points in general use.
// Keywords: convex hull, quickhull, half-edge, V-representation, H-representation.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "exact/number/tried.h"
#include "exact/solid/space_sign.h"

namespace findspace::space {

using exact::Approx3;
using exact::Grid3;
using exact::int128;
using exact::Wide3;

/// A grid point; |coordinate| <= 2^40.
using Point = Grid3;
inline constexpr std::int64_t kCoordinateLimit = std::int64_t{1} << 40;

/// The half space normal . x + offset <= 0. The normal of a facet points outward and its components are coprime.
struct Plane {
  Wide3 normal;
  int128 offset = 0;
  friend bool operator==(const Plane&, const Plane&) = default;
  friend auto operator<=>(const Plane&, const Plane&) = default;
};

/// One side of an edge: it runs from `origin` to `target`, with `facet` on its left and `right` on its right seen from
/// outside. `next` follows on the circuit of the facet; `turn` is the next one about the origin, clockwise from
/// outside. What could be found over `twin` is kept too: walks on the surface read one record a step.
struct HalfEdge {
  int origin = 0, target = 0, twin = 0, next = 0, turn = 0, facet = 0, right = 0;
};

/// What a factory found and repaired.
struct Repair {
  int duplicates = 0;   // input points that repeat an earlier one
  int not_extreme = 0;  // points inside the polytope, inside a facet or inside an edge
  int rounded = 0;      // vertices (of half spaces) that had to move to the grid
  double moved = 0;     // the longest such move, in grid steps
};

class Polytope {
 public:
  /// The convex hull. Throws Error(kGeometry) when the points lie in one plane, on one line or in one place, and
  /// Error(kOutOfRange) when a coordinate exceeds the limit.
  static Polytope hull(std::span<const Point> points, Repair* repair = nullptr);
  /// The same; refused with that Error(kGeometry) instead of thrown.
  static exact::Tried<Polytope> try_hull(std::span<const Point> points, Repair* repair = nullptr);

  /// The intersection of the half spaces. Vertices off the grid are put on it and counted in `repair`. Throws
  /// Error(kGeometry) when the intersection is empty, unbounded or flat. Cost O(n^3) for n half spaces.
  static Polytope from_half_spaces(std::span<const Plane> planes, Repair* repair = nullptr);

  std::span<const Point> vertices() const { return vertices_; }
  std::span<const HalfEdge> half_edges() const { return half_edges_; }
  std::span<const Plane> planes() const { return planes_; }
  int vertex_count() const { return static_cast<int>(vertices_.size()); }
  int edge_count() const { return static_cast<int>(half_edges_.size() / 2); }
  int facet_count() const { return static_cast<int>(planes_.size()); }

  /// The half-edges of facet f are first_half_edge(f) .. first_half_edge(f + 1) - 1, counter-clockwise from outside.
  int first_half_edge(int f) const { return first_[f]; }
  int circuit_size(int f) const { return first_[f + 1] - first_[f]; }
  std::vector<int> circuit(int f) const;

  /// One half-edge that starts at vertex v.
  int outgoing(int v) const { return outgoing_[v]; }
  int turn(int h) const { return half_edges_[h].turn; }
  int target(int h) const { return half_edges_[h].target; }
  /// The vector from its origin to its target.
  Point edge(int h) const { return vertices_[half_edges_[h].target] - vertices_[half_edges_[h].origin]; }

  /// Doubles that approx vertices and edge vectors (exactly) and facet normals (one rounding), for filters.
  const Approx3& vertex_approx(int v) const { return vertex_approx_[v]; }
  const Approx3& edge_approx(int h) const { return edge_approx_[h]; }
  const Approx3& normal_approx(int f) const { return normal_approx_[f]; }

  /// The same body moved by t, or reflected through the origin. Exact.
  Polytope translated(const Point& t) const;
  Polytope mirrored() const;

  /// Volume in cubic grid steps, to the roundings of a sum of doubles.
  double volume() const;

 private:
  friend class PolytopeBuilder;
  Polytope() = default;
  std::vector<Point> vertices_;
  std::vector<HalfEdge> half_edges_;
  std::vector<Plane> planes_;
  std::vector<int> first_;
  std::vector<int> outgoing_;
  std::vector<Approx3> vertex_approx_;
  std::vector<Approx3> edge_approx_;
  std::vector<Approx3> normal_approx_;
};

/// The sign of normal . (to - from): the filter first, then int128.
inline int sign_along(const Polytope& of_normal, int facet, const Polytope& of_edge, int from, int to) {
  const int fast =
      exact::filtered_sign_dot(of_normal.normal_approx(facet), of_edge.vertex_approx(to) - of_edge.vertex_approx(from));
  if (fast != 2) return fast;
  return exact::sign(exact::dot(of_normal.planes()[facet].normal, of_edge.vertices()[to] - of_edge.vertices()[from]));
}

/// The same along the half-edge h.
inline int sign_along(const Polytope& of_normal, int facet, const Polytope& of_edge, int h) {
  const int fast = exact::filtered_sign_dot(of_normal.normal_approx(facet), of_edge.edge_approx(h));
  return fast != 2 ? fast : exact::sign(exact::dot(of_normal.planes()[facet].normal, of_edge.edge(h)));
}

/// Assembles a polytope from convex facets given as vertex circuits that are already exact, merged and outward.
class PolytopeBuilder {
 public:
  static Polytope build(std::vector<Point> vertices, const std::vector<std::vector<int>>& circuits);
};

}  // namespace findspace::space
