// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces into triangles, and the simple maps of them that ray maps need.
#include <algorithm>
#include <set>
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

/// Exchanges the diagonals of triangles without area and their neighbours over the longest side: each time of the
/// first there is, until there is none, or it has no such neighbour.
class Flips {
 public:
  Flips(const std::vector<Point>& points, std::vector<Face>& faces) : points_(points), faces_(faces) {
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (flat(points, faces[f])) flat_.insert(f);
    if (flat_.empty()) return;
    for (std::size_t f = 0; f < faces.size(); ++f) enter(f);
  }

  void run() {
    for (std::size_t flips = faces_.size() * faces_.size(); flips > 0 && !flat_.empty() && flip(); --flips) {
    }
  }

 private:
  using Side = std::pair<int, int>;

  bool flip() {
    const std::size_t at = *flat_.begin();
    const Face f = faces_[at];
    int k = 0;  // the corner between the other two, opposite the longest side
    for (int i = 0; i < 3; ++i) {
      const Point &p = points_[f[i]], &q = points_[f[(i + 1) % 3]], &r = points_[f[(i + 2) % 3]];
      if ((q < p && p < r) || (r < p && p < q)) k = i;
    }
    const int m = f[k], a = f[(k + 1) % 3], b = f[(k + 2) % 3];
    auto beside = sides_.lower_bound({Side{b, a}, 0});
    if (beside != sides_.end() && *beside == std::pair{Side{b, a}, at}) ++beside;  // a triangle that runs out and back
    if (beside == sides_.end() || beside->first != Side{b, a}) return false;
    const std::size_t other = beside->second;
    const Face g = faces_[other];
    const int c = g[0] + g[1] + g[2] - a - b;
    exchange(at, {m, a, c});
    exchange(other, {m, c, b});
    return true;
  }

  void exchange(std::size_t f, const Face& by) {
    for (int i = 0; i < 3; ++i) sides_.erase({Side{faces_[f][i], faces_[f][(i + 1) % 3]}, f});
    flat_.erase(f);
    faces_[f] = by;
    enter(f);
    if (flat(points_, by)) flat_.insert(f);
  }

  void enter(std::size_t f) {
    for (int i = 0; i < 3; ++i) sides_.insert({Side{faces_[f][i], faces_[f][(i + 1) % 3]}, f});
  }

  const std::vector<Point>& points_;
  std::vector<Face>& faces_;
  std::set<std::size_t> flat_;
  std::set<std::pair<Side, std::size_t>> sides_;  // with the faces that have them, the first first
};

std::vector<Face> cut(const Mesh& mesh, const std::vector<int>& face) {
  if (face.size() == 3) return {{face[0], face[1], face[2]}};
  std::vector<Face> faces;
  const Wide3 n = area_vector(mesh, face);
  for (const auto& [a, b, c] : triangulate(projected(mesh, face, n), StraightCorner::kKeep)) {
    faces.push_back({face[a], face[b], face[c]});
  }
  Flips(mesh.vertices, faces).run();
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
