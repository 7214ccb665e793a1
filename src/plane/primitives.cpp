// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/primitives.h"

#include <algorithm>

#include "plane/around_vertex.h"
#include "plane/piece_builder.h"
#include "plane/simplify.h"
#include "plane/winding.h"

namespace findspace::plane {
namespace {

/// Valid rings need no arrangement: their pieces are the edges, in order.
class RingBuilder {
 public:
  Region build(std::span<const Contour> rings) {
    faces(Index(rings.size()) + 1);
    for (Index r = 0; r < rings.size(); ++r) add(rings[r], r == 0 ? 0 : r + 1);
    region_.geometry = std::move(builder_.geometry);
    for (Index v = 0; v < region_.vertices.size(); ++v) set_first(v);
    return could_merge_ ? simplify(region_) : std::move(region_);
  }

 private:
  void faces(Index count) {
    region_.faces.reserve(count);
    for (Index f = 0; f < count; ++f)
      region_.faces.push_back(Face{.mark = Mark(f == 1), .outer = kNone, .inner = {}, .isolated = {}});
  }

  /// One ring with face 1 on its left and `outside` on its right.
  void add(const Contour& ring, Index outside) {
    Index first = Index(builder_.pieces.size()), n = Index(ring.size());
    make_room(n);
    std::vector<Index> corner;
    corner.reserve(n);
    for (const ContourEdge& e : ring) corner.push_back(builder_.geometry.add_grid_point(e.start.x, e.start.y));
    for (Index k = 0; k < n; ++k) {
      Index next = k + 1 == n ? 0 : k + 1;
      const ContourEdge& e = ring[k];
      if (e.arc)
        builder_.arc(builder_.geometry.add(exact::Carrier::circle_at(e.arc->cx, e.arc->cy, e.arc->r)), corner[k],
                     corner[next], e.ccw);
      else
        builder_.segment(builder_.line(e.start, ring[next].start), corner[k], corner[next], e.start < ring[next].start);
    }
    Index end = Index(builder_.pieces.size());
    Face &inner = region_.faces[1], &outer = region_.faces[outside];
    if (outside == 0)
      inner.outer = along(first), outer.inner.push_back(along(first) ^ 1u);
    else
      inner.inner.push_back(along(first)), outer.outer = along(first) ^ 1u;
    for (Index i = first; i < end; ++i) {
      const Piece& p = builder_.pieces[i];
      could_merge_ |= could_continue(builder_.pieces[i == first ? end - 1 : i - 1], p);
      bool forward = builder_.forward[i];
      Index from = Index(region_.vertices.size()), to = i + 1 == end ? from - (end - 1 - first) : from + 1;
      Index before = i == first ? end - 1 : i - 1, after = i + 1 == end ? first : i + 1;
      region_.vertices.push_back({.point = forward ? p.p0 : p.p1, .mark = 1, .out = along(i), .face = kNone});
      region_.edges.push_back({forward ? from : to, forward ? to : from, p.carrier, p.half, 1});
      region_.half_edges.resize(region_.edges.size() * 2);
      region_.half_edges[along(i)] = {along(after), 1};
      region_.half_edges[along(i) ^ 1u] = {along(before) ^ 1u, outside};
    }
  }

  /// For the edges of one more ring, arcs aside.
  void make_room(std::size_t edges) {
    auto grow = [edges](auto& v) { v.reserve(std::max(v.size() + edges, 2 * v.size())); };
    grow(builder_.geometry.carriers), grow(builder_.geometry.points), grow(builder_.pieces), grow(builder_.forward);
    grow(region_.vertices), grow(region_.edges);
    region_.half_edges.reserve(std::max(region_.half_edges.size() + 2 * edges, 2 * region_.half_edges.size()));
  }

  /// Parallel lines or halves of the same kind: only such neighbours can be one edge.
  bool could_continue(const Piece& p, const Piece& q) const {
    if (p.half != q.half) return false;
    const exact::Carrier &k = builder_.geometry.carriers[p.carrier], &l = builder_.geometry.carriers[q.carrier];
    return p.half != 0 || (k.a == l.a && k.b == l.b);
  }

  Index along(Index piece) const { return 2 * piece + (builder_.forward[piece] ? 0 : 1); }

  /// Of the two half-edges at a vertex, the first counter-clockwise from straight down.
  void set_first(Index v) {
    Index h = region_.vertices[v].out, k = region_.clockwise(h);
    bool swap = (h & 1u) != (k & 1u) ? (h & 1u)
                                     : !comes_before(region_.geometry, region_.vertices[v].point, h & 1u,
                                                     region_.heading(h), region_.edges[h / 2].half, region_.heading(k));
    if (swap) region_.vertices[v].out = k;
  }

  PieceBuilder builder_;
  Region region_;
  bool could_merge_ = false;
};

/// Faces with a positive winding number, and everything on their boundary.
Region closed_inside(PieceBuilder b) {
  std::vector<char> forward = std::move(b.forward);
  Arrangement a = arrange(std::move(b.geometry), std::move(b.pieces));
  auto number = face_windings(a, forward, 0);
  Marks m;
  for (auto k : number) m.faces.push_back(k > 0);
  m.vertices.assign(a.vertex_count(), 0);
  for (Index e = 0; e < a.edge_count(); ++e) {
    bool in = m.faces[a.face[2 * e]] || m.faces[a.face[2 * e + 1]];
    m.edges.push_back(in);
    if (in) m.vertices[a.edges[e].v0] = m.vertices[a.edges[e].v1] = 1;
  }
  return extract(a, m);
}

Region all_cells(PieceBuilder b, std::span<const Index> isolated) {
  Arrangement a = arrange(std::move(b.geometry), std::move(b.pieces), isolated);
  Marks m;
  m.faces.assign(a.face_count, 0);
  m.edges.assign(a.edge_count(), 1);
  m.vertices.assign(a.vertex_count(), 1);
  return extract(a, m);
}

}  // namespace

Region region_of_rings(std::span<const Contour> rings) { return RingBuilder().build(rings); }

Region region_of_disc(const exact::Real& cx, const exact::Real& cy, const exact::Real& radius) {
  PieceBuilder b;
  b.circle(b.geometry.add(exact::Carrier::circle_at(cx, cy, radius)));
  return closed_inside(std::move(b));
}

Region region_of_points(std::span<const GridPoint> points) {
  PieceBuilder b;
  std::vector<Index> isolated;
  for (const GridPoint& p : points) isolated.push_back(b.geometry.add_grid_point(p.x, p.y));
  return all_cells(std::move(b), isolated);
}

Region region_of_chain(const Contour& chain) {
  PieceBuilder b;
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) b.edge(chain[k], chain[k + 1].start);
  return all_cells(std::move(b), {});
}

}  // namespace findspace::plane
