// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces into triangles, and the simple maps of them that ray maps need.
#include <algorithm>
#include <map>
#include <utility>

#include "space/convolution/ray_body.h"
#include "space/mesh/mesh.h"
#include "space/polytope/triangulate.h"

namespace findspace::space {
namespace {

using Face = std::array<int, 3>;

bool flat(const std::vector<Point>& points, const Face& f) {
  return exact::is_zero(exact::cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[0]]));
}

/// Exchanges the diagonal of a triangle without area and its neighbour over the longest side. True if there was one.
bool flip_flat(const std::vector<Point>& points, std::vector<Face>& faces) {
  for (Face& f : faces) {
    if (!flat(points, f)) continue;
    int k = 0;  // the corner between the other two, opposite the longest side
    for (int i = 0; i < 3; ++i) {
      const Point &p = points[f[i]], &q = points[f[(i + 1) % 3]], &r = points[f[(i + 2) % 3]];
      if ((q < p && p < r) || (r < p && p < q)) k = i;
    }
    const int m = f[k], a = f[(k + 1) % 3], b = f[(k + 2) % 3];
    for (Face& g : faces) {
      for (int i = 0; i < 3; ++i) {
        if (&g == &f || g[i] != b || g[(i + 1) % 3] != a) continue;
        const int c = g[(i + 2) % 3];
        f = {m, a, c};
        g = {m, c, b};
        return true;
      }
    }
    return false;
  }
  return false;
}

std::vector<Face> cut(const Mesh& mesh, const std::vector<int>& face) {
  if (face.size() == 3) return {{face[0], face[1], face[2]}};
  std::vector<Face> faces;
  const Wide3 n = area_vector(mesh, face);
  for (const auto& [a, b, c] : triangulate(projected(mesh, face, n), StraightCorner::kKeep)) {
    faces.push_back({face[a], face[b], face[c]});
  }
  for (std::size_t flips = faces.size() * faces.size(); flips > 0 && flip_flat(mesh.vertices, faces); --flips) {
  }
  return faces;
}

}  // namespace

Triangles triangles(const Mesh& mesh) {
  Triangles t{mesh.vertices, {}};
  for (const auto& face : mesh.faces) {
    for (const Face& f : cut(mesh, face)) t.faces.push_back(f);
  }
  return t;
}

Triangles triangles(const Polytope& polytope) {
  Triangles t{{polytope.vertices().begin(), polytope.vertices().end()}, {}};
  for (int f = 0; f < polytope.facet_count(); ++f) {
    const std::vector<int> ring = polytope.circuit(f);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) t.faces.push_back({ring[0], ring[i], ring[i + 1]});
  }
  return t;
}

Triangles scaled(Triangles t, std::int64_t factor) {
  for (Point& p : t.points) p = {p.x * factor, p.y * factor, p.z * factor};
  return factor < 0 ? inside_out(std::move(t)) : t;
}

Triangles moved(Triangles t, const Point& by) {
  for (Point& p : t.points) p = p + by;
  return t;
}

Triangles inside_out(Triangles t) {
  for (Face& f : t.faces) std::swap(f[1], f[2]);
  return t;
}

Triangles with_axis(Triangles t, int axis) {
  for (Point& p : t.points) p = axis == 0 ? Point{p.y, p.z, p.x} : axis == 1 ? Point{p.z, p.x, p.y} : p;
  return t;
}

}  // namespace findspace::space
