// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/boundary_components.h"

#include <algorithm>
#include <span>
#include <unordered_map>

#include "plane/complex/extent.h"
#include "plane/complex/simplify.h"

namespace findspace::plane {
namespace {

/// New numbers for the cells that are kept.
class Numbering {
 public:
  void add(Index old) { of_.emplace(old, Index(of_.size())); }
  Index cell(Index old) const { return old == kNone ? kNone : of_.at(old); }
  Index half_edge(Index old) const { return old == kNone ? kNone : 2 * of_.at(old / 2) + (old & 1u); }

 private:
  std::unordered_map<Index, Index> of_;
};

/// The supporting curves and points that the cells of `out`, numbered as in `from`, need; in order, so that crossings
/// keep the order of their supporting_curves.
void take_geometry(CellComplex& out, const exact::Geometry& from) {
  std::vector<Index> supporting_curves;
  for (const Edge& e : out.edges) supporting_curves.push_back(e.supporting_curve);
  for (const Vertex& v : out.vertices) {
    const exact::Point& p = from.points[v.point];
    if (p.kind == exact::Point::Kind::kCross) supporting_curves.insert(supporting_curves.end(), {p.i, p.j});
  }
  std::sort(supporting_curves.begin(), supporting_curves.end());
  supporting_curves.erase(std::unique(supporting_curves.begin(), supporting_curves.end()), supporting_curves.end());
  const auto number = [&](Index k) {
    return Index(std::lower_bound(supporting_curves.begin(), supporting_curves.end(), k) - supporting_curves.begin());
  };
  exact::Geometry& to = out.geometry;
  for (const Index k : supporting_curves) to.add(from.supporting_curves[k]);
  for (Edge& e : out.edges) e.supporting_curve = number(e.supporting_curve);
  for (Vertex& v : out.vertices) {
    exact::Point p = from.points[v.point];
    if (p.kind == exact::Point::Kind::kCross) {
      p.i = number(p.i);
      p.j = number(p.j);
    }
    if (p.kind == exact::Point::Kind::kReal) {
      to.reals.push_back(from.reals[p.i]);
      p.i = Index(to.reals.size() - 1);
    }
    v.point = Index(to.points.size());
    to.points.push_back(p);
  }
}

}  // namespace

/// Collects a component's cells from one of its half-edges on.
class BoundaryComponents::Flood {
 public:
  Flood(const CellComplex& a, BoundaryComponents& out)
      : a_(a), out_(out), edge_(a.edges.size(), 0), face_(a.faces.size(), 0), vertex_(a.vertices.size(), 0) {
    face_[0] = 1;
    out.edges_.reserve(a.edges.size());
    out.vertices_.reserve(a.vertices.size());
    out.faces_.reserve(a.faces.size());
    out.boundary_components_.reserve(a.faces[0].inner.size() + a.faces[0].isolated.size());
  }

  void from_half_edge(Index start) {
    PieceBox box = edge_box(a_, start / 2);
    todo_.push_back(start);
    while (!todo_.empty()) {
      const Index e = todo_.back() / 2;
      todo_.pop_back();
      if (edge_[e]) continue;
      edge_[e] = 1;
      out_.edges_.push_back(e);
      box = joined(box, edge_box(a_, e));
      take_vertex(a_.edges[e].v0);
      take_vertex(a_.edges[e].v1);
      for (const Index side : {2 * e, 2 * e + 1}) {
        todo_.push_back(a_.next(side));
        take_face(a_.face(side));
      }
    }
    close(box, start);
  }

  void from_vertex(Index v) {
    take_vertex(v);
    const exact::Point& p = a_.point(v);
    close({p.x - p.error, p.y - p.error, p.x + p.error, p.y + p.error}, v);
  }

 private:
  void take_vertex(Index v) {
    if (!vertex_[v]) out_.vertices_.push_back(v);
    vertex_[v] = 1;
  }

  void take_face(Index f) {
    if (face_[f]) return;
    face_[f] = 1;
    out_.faces_.push_back(f);
    for (const Index h : a_.faces[f].inner) todo_.push_back(h);
    for (const Index v : a_.faces[f].isolated) take_vertex(v);
  }

  void close(const PieceBox& box, Index start) {
    out_.boundary_components_.push_back({box, start, out_.edges_.size(), out_.faces_.size(), out_.vertices_.size()});
  }

  const CellComplex& a_;
  BoundaryComponents& out_;
  std::vector<char> edge_, face_, vertex_;  // taken
  std::vector<Index> todo_;
};

BoundaryComponents::BoundaryComponents(const CellComplex& a) {
  Flood flood(a, *this);
  for (const Index h : a.faces[0].inner) flood.from_half_edge(h);
  for (const Index v : a.faces[0].isolated) flood.from_vertex(v);
}

std::size_t BoundaryComponents::edge_count(Index k) const {
  return boundary_components_[k].edges_end - before(k).edges_end;
}

CellComplex BoundaryComponents::near(const CellComplex& a, const PieceBox& window) const {
  std::vector<Index> chosen;
  for (Index k = 0; k < size(); ++k)
    if (box(k).meets(window)) chosen.push_back(k);
  return of(a, chosen);
}

CellComplex BoundaryComponents::of(const CellComplex& a, std::span<const Index> chosen) const {
  std::vector<Index> edges, vertices, faces{0}, outer, alone;
  for (const Index k : chosen) {
    const BoundaryComponent start = before(k), &end = boundary_components_[k];
    edges.insert(edges.end(), edges_.begin() + start.edges_end, edges_.begin() + end.edges_end);
    faces.insert(faces.end(), faces_.begin() + start.faces_end, faces_.begin() + end.faces_end);
    vertices.insert(vertices.end(), vertices_.begin() + start.vertices_end, vertices_.begin() + end.vertices_end);
    (start.edges_end < end.edges_end ? outer : alone).push_back(end.start);
  }
  Numbering edge, vertex, face;
  for (const Index e : edges) edge.add(e);
  for (const Index v : vertices) vertex.add(v);
  for (const Index f : faces) face.add(f);
  CellComplex out;
  for (const Index v : vertices) {
    const Vertex& was = a.vertices[v];
    out.vertices.push_back({was.point, was.mark, edge.half_edge(was.out), face.cell(was.face)});
  }
  for (const Index e : edges) {
    const Edge& was = a.edges[e];
    out.edges.push_back({vertex.cell(was.v0), vertex.cell(was.v1), was.supporting_curve, was.half, was.mark});
    for (const Index h : {2 * e, 2 * e + 1})
      out.half_edges.push_back({edge.half_edge(a.next(h)), face.cell(a.face(h))});
  }
  for (const Index f : faces) {
    const Face& was = a.faces[f];
    Face& now = out.faces.emplace_back(Face{was.mark, edge.half_edge(was.outer), {}, {}});
    const std::span<const Index> inner = f == 0 ? std::span<const Index>(outer) : was.inner;
    const std::span<const Index> isolated = f == 0 ? std::span<const Index>(alone) : was.isolated;
    for (const Index h : inner) now.inner.push_back(edge.half_edge(h));
    for (const Index v : isolated) now.isolated.push_back(vertex.cell(v));
  }
  take_geometry(out, a.geometry);
  return out;
}

Region within(const Region& a, const PieceBox& window) {
  std::vector<PieceBox> box;
  box.reserve(a.edges.size());
  for (Index e = 0; e < a.edges.size(); ++e) box.push_back(edge_box(a, e));
  Region out = a;
  for (Vertex& v : out.vertices) v.mark = 0;
  for (Edge& e : out.edges) e.mark = 0;
  const auto keep_edge = [&](Index e) {
    out.edges[e].mark = a.edges[e].mark;
    for (const Index v : {a.edges[e].v0, a.edges[e].v1}) out.vertices[v].mark = a.vertices[v].mark;
  };
  for (Index f = 1; f < a.faces.size(); ++f) {
    if (a.faces[f].mark <= 0) continue;
    const Index outer = a.faces[f].outer;
    PieceBox all = box[outer / 2];
    for (Index h = a.next(outer); h != outer; h = a.next(h)) all = joined(all, box[h / 2]);
    if (!all.meets(window)) out.faces[f].mark = 0;
  }
  for (Index e = 0; e < a.edges.size(); ++e) {
    const bool of_face = out.faces[a.face(2 * e)].mark > 0 || out.faces[a.face(2 * e + 1)].mark > 0;
    if (a.edges[e].mark > 0 && (of_face || box[e].meets(window))) keep_edge(e);
  }
  for (Index v = 0; v < a.vertices.size(); ++v)
    if (a.vertices[v].out == kNone) out.vertices[v].mark = a.vertices[v].mark;
  return simplify(std::move(out));
}

}  // namespace findspace::plane
