// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/query/in_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "exact/planar/geometry_signs.h"
#include "plane/base/sort_at_once.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kManyVertices = 1 << 13;  // from here on in several threads

class Renumbering {
 public:
  explicit Renumbering(CellComplex from) : from_(std::move(from)) {
    order_vertices();
    order_edges();
  }

  /// A list of the complex goes as soon as the new one stands.
  CellComplex run() {
    number_faces();
    out_.vertices.reserve(vertices_.size());
    for (Index v : vertices_) out_.vertices.push_back(moved(from_.vertices[v]));
    from_.vertices = {};
    out_.edges.reserve(edges_.size());
    for (Index e : edges_) {
      Edge edge = from_.edges[e];
      edge.v0 = vertex_[edge.v0];
      edge.v1 = vertex_[edge.v1];
      out_.edges.push_back(edge);
    }
    from_.edges = {};
    out_.half_edges.reserve(2 * edges_.size());
    for (Index e : edges_)
      for (Index h : {2 * e, 2 * e + 1}) out_.half_edges.push_back({half_edge(from_.next(h)), face_[from_.face(h)]});
    from_.half_edges = {};
    bound_faces();
    out_.geometry = std::move(from_.geometry);
    return std::move(out_);
  }

 private:
  void order_vertices() {
    vertices_.resize(from_.vertices.size());
    std::iota(vertices_.begin(), vertices_.end(), Index(0));
    sort_at_once(vertices_.begin(), vertices_.end(), kManyVertices, [&](Index v, Index w) {
      return compare_xy(from_.geometry, from_.vertices[v].point, from_.vertices[w].point) < 0;
    });
    vertex_.resize(vertices_.size());
    for (std::size_t k = 0; k < vertices_.size(); ++k) vertex_[vertices_[k]] = Index(k);
  }

  void order_edges() {
    edge_.resize(from_.edges.size());
    edges_.reserve(from_.edges.size());
    std::vector<Index> around;  // counter-clockwise, those to the right first
    for (Index v : vertices_) {
      const Index first = from_.vertices[v].out;
      if (first == kNone) continue;
      around.assign(1, first);
      for (Index h = from_.clockwise(first); h != first; h = from_.clockwise(h)) around.push_back(h);
      std::reverse(around.begin() + 1, around.end());
      for (Index h : around) {
        if (h & 1u) continue;
        edge_[h / 2] = Index(edges_.size());
        edges_.push_back(h / 2);
      }
    }
  }

  Index half_edge(Index h) const { return 2 * edge_[h / 2] + (h & 1u); }

  Vertex moved(Vertex v) const {
    if (v.out != kNone) v.out = half_edge(v.out);
    if (v.face != kNone) v.face = face_[v.face];
    return v;
  }

  void number_faces() {
    face_.assign(from_.faces.size(), kNone);
    out_.faces.reserve(from_.faces.size());
    auto use = [&](Index f) {
      if (face_[f] != kNone) return;
      face_[f] = Index(out_.faces.size());
      out_.faces.push_back(Face{.mark = from_.faces[f].mark, .outer = kNone, .inner = {}, .isolated = {}});
    };
    use(0);
    for (Index e : edges_) {
      use(from_.face(2 * e));
      use(from_.face(2 * e + 1));
    }
  }

  /// Boundary cycles begin at their first half-edge, except that an inner one keeps the one at its smallest vertex.
  void bound_faces() {
    for (std::size_t f = 0; f < face_.size(); ++f) {
      const Face& face = from_.faces[f];
      Face& to = out_.faces[face_[f]];
      for (Index h : face.inner) to.inner.push_back(half_edge(h));
      for (Index v : face.isolated) to.isolated.push_back(vertex_[v]);
      std::sort(to.inner.begin(), to.inner.end());
      std::sort(to.isolated.begin(), to.isolated.end());
      if (face.outer == kNone) continue;
      to.outer = half_edge(face.outer);
      const Index first = to.outer;
      for (Index h = out_.next(first); h != first; h = out_.next(h)) to.outer = std::min(to.outer, h);
    }
  }

  CellComplex from_;
  CellComplex out_;
  std::vector<Index> vertices_, edges_;      // new number -> old
  std::vector<Index> vertex_, edge_, face_;  // old number -> new
};

}  // namespace

CellComplex in_order(CellComplex complex) { return Renumbering(std::move(complex)).run(); }

}  // namespace findspace::plane
