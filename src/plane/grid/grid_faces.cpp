// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/grid_faces.h"

#include <algorithm>
#include <string>

#include "exact/planar/grid_coordinates.h"

namespace findspace::plane {
namespace {

using exact::int128;

int sign(int128 v) { return (v > 0) - (v < 0); }

bool is_lower(const GridCorner& c) { return c.dy < 0 || (c.dy == 0 && c.dx < 0); }

class Walk {
 public:
  Walk(const CellComplex& c, bool mirrored)
      : c_(c),
        edges_(c.edges.data()),
        curves_(c.geometry.supporting_curves.data()),
        vertices_(c.vertices.data()),
        points_(c.geometry.points.data()),
        mirrored_(mirrored) {}

  /// Were all edges so far segments between grid points?
  bool on_grid() const { return on_grid_; }

  void ring(Index start, GridCorners& out) {
    const HalfEdge* const half_edges = c_.half_edges.data();
    const Index first = Index(out.size());
    Index end = first, h = start;
    do {
      ++end;
      h = half_edges[h].next;
    } while (h != start);
    out.resize(end);
    GridCorner *corner = &out[first], *const ring = corner - first;
    for (Index k = first; k < end; ++k, ++corner, h = half_edges[h].next) {
      set(*corner, h);
      corner->before = k - 1;
      corner->next = k + 1;
      if (k > first) set_turn(corner[-1], *corner);
    }
    ring[first].before = end - 1;
    ring[end - 1].next = first;
    set_turn(ring[end - 1], ring[first]);
  }

 private:
  static void set_turn(const GridCorner& before, GridCorner& corner) {
    corner.turn = std::int8_t(sign(int128(before.dx) * corner.dy - int128(before.dy) * corner.dx));
  }

  /// The corner where a half-edge starts, but for its neighbours.
  void set(GridCorner& g, Index h) {
    const Edge& e = edges_[h / 2];
    const exact::SupportingCurve& k = curves_[e.supporting_curve];
    const auto p = grid_coordinates(c_.geometry, points_[vertices_[h & 1u ? e.v1 : e.v0].point]);
    on_grid_ &= e.half == 0 && k.grid && p.has_value();
    if (!on_grid_) return;
    // To the right along a*x + b*y = c: (b, -a) or its opposite.
    const bool flipped = ((k.b > 0) == bool(h & 1u)) != mirrored_;
    g.dx = flipped ? -k.b : k.b;
    g.dy = flipped ? k.a : -k.a;
    g.at = mirrored_ ? GridPoint{-p->x, -p->y} : GridPoint{p->x, p->y};
    g.supporting_curve = e.supporting_curve;
  }

  const CellComplex& c_;
  const Edge* edges_;
  const exact::SupportingCurve* curves_;
  const Vertex* vertices_;
  const exact::Point* points_;
  bool mirrored_, on_grid_ = true;
};

/// Whether faces are wanted, by their numbers. A few need no memory.
using Faces = std::string;

bool is_beside(const CellComplex& c, Index e, const Faces& in) { return in[c.face(2 * e)] || in[c.face(2 * e + 1)]; }

/// Whether a wanted vertex has no edge beside one of the faces. `edges_beside`: all of them are.
bool has_vertex_apart(const CellComplex& c, const Faces& in, bool edges_beside, bool (*wanted)(Mark)) {
  if (edges_beside)
    return std::any_of(c.vertices.begin(), c.vertices.end(),
                       [&](const Vertex& v) { return v.out == kNone && wanted(v.mark); });
  std::vector<char> near(c.vertices.size(), 0);
  for (Index e = 0; e < c.edges.size(); ++e)
    if (is_beside(c, e, in)) near[c.edges[e].v0] = near[c.edges[e].v1] = 1;
  for (Index v = 0; v < c.vertices.size(); ++v)
    if (!near[v] && wanted(c.vertices[v].mark)) return true;
  return false;
}

/// Whether a wanted edge or vertex lies outside the closure of the faces, or an edge has one of them on both sides.
bool has_more(const CellComplex& c, const Faces& in, bool (*wanted)(Mark)) {
  bool edges_beside = true;
  const Index n = Index(c.edges.size());
  const HalfEdge* half_edge = c.half_edges.data();
  for (Index e = 0; e < n; ++e, half_edge += 2) {
    const Index left = half_edge[0].face, right = half_edge[1].face;
    const bool beside = in[left] || in[right];
    if (beside ? left == right : wanted(c.edges[e].mark)) return true;
    edges_beside &= beside;
  }
  return has_vertex_apart(c, in, edges_beside, wanted);
}

}  // namespace

bool GridFace::is_convex() const {
  if (unbounded) return false;
  int rounds = 0;
  for (const GridCorner& k : corners) {
    if (k.turn <= 0 || (&k != corners.data() && k.before + 1 != Index(&k - corners.data()))) return false;
    rounds += is_lower(corners[k.before]) && !is_lower(k);
  }
  return rounds == 1;
}

std::optional<GridFaces> grid_faces(const CellComplex& c, bool (*wanted)(Mark), bool mirrored, Memory memory) {
  Faces in(c.faces.size(), 0);
  for (Index f = 0; f < c.faces.size(); ++f) in[f] = char(wanted(c.faces[f].mark));
  if (has_more(c, in, wanted)) return std::nullopt;
  GridFaces faces(memory);
  faces.reserve(std::size_t(std::count(in.begin(), in.end(), char(1))));
  Walk walk(c, mirrored);
  for (Index f = 0; f < c.faces.size(); ++f) {
    if (!in[f]) continue;
    for (Index v : c.faces[f].isolated)
      if (!wanted(c.vertices[v].mark)) return std::nullopt;
    GridFace& face = faces.emplace_back(memory);
    face.unbounded = f == 0;
    if (c.faces[f].outer != kNone) walk.ring(c.faces[f].outer, face.corners);
    for (Index h : c.faces[f].inner) walk.ring(h, face.corners);
    if (!walk.on_grid()) return std::nullopt;
  }
  return faces;
}

}  // namespace findspace::plane
