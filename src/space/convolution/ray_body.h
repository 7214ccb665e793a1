// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A solid as ray maps want it: a closed surface of triangles, counter-clockwise from outside, with the edges and the
// circuits of corners about its vertices. The solid is what lies behind the triangles: a surface turned inside out
// bounds the complement. Where four or more triangles meet in an edge they are paired so that each pair has solid
// between it; a vertex at which several circuits meet counts once for each circuit. Guarantee: exact. A surface that is
// not closed, folds back on itself or repeats a face is refused with Error(kGeometry); whether it crosses itself is not
// checked here. Cost: O(n log n). Keywords: triangle mesh, half-edge, link of a vertex, dihedral angle.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "exact/number/tried.h"
#include "exact/solid/ray_sign.h"
#include "space/polytope/solid.h"

namespace findspace::space {

/// Whether the point, taken times a factor, is no farther out than ray_sign.h allows.
bool in_ray_range(const Point& p, std::int64_t factor = 1);
/// Of points that are not.
exact::Refusal beyond_ray_range();

struct Triangles {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> faces;
  double step = 0;  // the size of a grid step in messages; 0: they say "in grid steps"
};

/// The faces of a clean mesh (mesh.h) cut into triangles that have an area and match edge by edge.
Triangles triangles(const Mesh& mesh);
/// The boundary of a polytope.
Triangles triangles(const Polytope& polytope);

/// The points multiplied by `factor` (which may be -1: reflection through the origin; faces are turned to match) and
/// moved.
Triangles scaled(Triangles t, std::int64_t factor);
Triangles moved(Triangles t, const Point& by);
/// The same surface seen from the other side: the complement of the solid.
Triangles inside_out(Triangles t);
/// The axes exchanged so that `axis` (0, 1, 2) becomes the third: (x, y, z), (y, z, x) or (z, x, y).
Triangles with_axis(Triangles t, int axis);

/// One side of a triangle: `from` to `to` runs along face `left`; the neighbour over it is face `right`.
struct RayEdge {
  int from = 0, to = 0, left = 0, right = 0;
  int bend = 0;  // +1 convex, -1 reflex, 0 flat
};

/// A face's corner at a vertex: the edge that leaves the vertex along the face.
struct RayCorner {
  int to = 0, face = 0;
};

/// A body's vertex as its circuit of corners: corner j has its face between the edges to corners j and j + 1.
struct RayVertex {
  int point = 0, first = 0, count = 0;
};

struct RayBody {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> faces;
  std::vector<Wide3> normals;  // outward, not reduced
  std::vector<Approx3> normal_approx;
  std::vector<RayEdge> edges;
  std::vector<std::array<int, 3>> face_edges;  // of face f, edge k joins corners k and k + 1
  std::vector<RayVertex> vertices;
  std::vector<RayCorner> corners;
  std::vector<int> piece;  // of each face: faces joined by edges have the same number, from 0
  int pieces = 0;
  std::vector<int> first_face;  // of each piece
  Point low, high;

  /// Refused where the triangles are not a closed surface that lies about a solid (kGeometry) or lie too far out.
  static exact::Tried<RayBody> of(Triangles surface);
  /// The same; the error instead of the refusal.
  explicit RayBody(Triangles surface) : RayBody(of(std::move(surface)).or_throw()) {}

  const Point& corner(int face, int k) const { return points[faces[face][k]]; }
  /// V - E + F over 2: the Euler characteristic of a bounded solid with this boundary.
  int euler() const;

 private:
  RayBody() = default;
  /// The faces' normals and the box; what is wrong with a face.
  std::optional<exact::Refusal> measure_faces();
};

}  // namespace findspace::space
