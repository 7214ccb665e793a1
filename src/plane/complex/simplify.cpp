// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/simplify.h"

#include <algorithm>
#include <span>
#include <utility>

#include "exact/planar/geometry_signs.h"
#include "plane/base/parallel.h"
#include "plane/base/release.h"
#include "plane/base/union_find.h"
#include "plane/complex/arrangement.h"
#include "plane/complex/keep_used.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kManyToClassify = 4000;  // vertices: from here on ranges of them are worked on at once

/// Cells to be merged, read where they are: of a complex, or of an arrangement with its marks. Their geometry, most of
/// the memory of a large set, is taken and not copied. A list goes as soon as nothing reads it.
struct ComplexCells {
  CellComplex& c;

  exact::Geometry& geometry() const { return c.geometry; }
  Index vertex_count() const { return Index(c.vertices.size()); }
  Index edge_count() const { return Index(c.edges.size()); }
  Index face_count() const { return Index(c.faces.size()); }
  const Vertex& vertex(Index v) const { return c.vertices[v]; }
  const Edge& edge(Index e) const { return c.edges[e]; }
  Mark face_mark(Index f) const { return c.faces[f].mark; }
  Index next(Index h) const { return c.half_edges[h].next; }
  Index face(Index h) const { return c.half_edges[h].face; }
  void release_vertices() const { release(c.vertices); }
  void release_edges() const { release(c.edges); }
  void release_half_edges() const { release(c.half_edges); }
};

struct ArrangedCells {
  Arrangement& a;
  const MarkViews& marks;

  exact::Geometry& geometry() const { return a.geometry; }
  Index vertex_count() const { return a.vertex_count(); }
  Index edge_count() const { return a.edge_count(); }
  Index face_count() const { return Index(marks.faces.size()); }
  Vertex vertex(Index v) const {
    return {a.vertex_point[v], marks.vertices[v], a.degree(v) ? a.out[a.out_start[v]] : kNone, a.isolated_face[v]};
  }
  Edge edge(Index e) const {
    const Arrangement::Edge& d = a.edges[e];
    return {d.v0, d.v1, d.supporting_curve, d.half, marks.edges[e]};
  }
  Mark face_mark(Index f) const { return marks.faces[f]; }
  Index next(Index h) const { return a.next[h]; }
  Index face(Index h) const { return a.face[h]; }
  void release_vertices() const {
    for (auto* list : {&a.vertex_point, &a.out_start, &a.out, &a.isolated_face}) release(*list);
  }
  void release_edges() const { release(a.edges); }
  void release_half_edges() const {
    for (auto* list : {&a.next, &a.face}) release(*list);
  }
};

template <class Cells>
class Merger {
 public:
  Merger(const Cells& raw, Memory memory)
      : raw_(raw),
        geometry_(raw.geometry()),
        memory_(memory),
        faces_(raw.face_count(), memory),
        kept_(memory),
        passes_(memory),
        first_(memory),
        starts_(memory),
        ends_(memory),
        first_part_(memory),
        last_part_(memory) {}

  CellComplex run() {
    drop_edges();
    classify_vertices();
    make_edges();
    raw_.release_edges();
    make_vertices();
    raw_.release_vertices();
    release(first_);
    release(passes_);
    link();
    raw_.release_half_edges();
    for (auto* list : {&starts_, &ends_, &first_part_, &last_part_}) release(*list);
    number_faces();
    collect_cycles();
    compact_geometry();
    return std::move(out_);
  }

 private:
  bool kept(Index half_edge) const { return kept_[half_edge / 2]; }

  void drop_edges() {
    kept_.resize(raw_.edge_count());
    for (Index e = 0; e < raw_.edge_count(); ++e) {
      Index left = raw_.face(2 * e), right = raw_.face(2 * e + 1);
      Mark m = raw_.edge(e).mark;
      kept_[e] = raw_.face_mark(left) != m || raw_.face_mark(right) != m;
      if (!kept_[e]) faces_.unite(left, right);
    }
  }

  /// The kept half-edges around a vertex.
  struct Star {
    Index count = 0;
    Index first = kNone, second = kNone;  // counter-clockwise from straight down; `second` only if there are two
  };

  Star kept_around(Index v) const {
    Star star;
    Index begin = raw_.vertex(v).out, h = begin;
    if (begin == kNone) return star;
    do {  // clockwise: the first one, then the last, ... , the second
      if (kept(h)) {
        ++star.count;
        if (h == begin) {
          star.first = h;
        } else if (star.first == begin) {
          star.second = h;
        } else {
          star.second = star.first;
          star.first = h;
        }
      }
      h = raw_.next(h ^ 1u);
    } while (h != begin);
    return star;
  }

  bool same_curve(const Edge& e, const Edge& f) const {
    const auto& supporting_curves = geometry_.supporting_curves;
    return e.half == f.half &&
           (e.supporting_curve == f.supporting_curve ||
            same_supporting_curve(supporting_curves[e.supporting_curve], supporting_curves[f.supporting_curve]));
  }

  void classify_vertices() {
    first_.assign(raw_.vertex_count(), kNone);
    passes_.assign(raw_.vertex_count(), 0);
    in_ranges(raw_.vertex_count(), kManyToClassify, [&](IndexRange vertices) {
      for (auto v = Index(vertices.first); v < vertices.end; ++v) classify(v);
    });
  }

  void classify(Index v) {
    Star star = kept_around(v);
    first_[v] = star.first;
    // Two edges, one to the right and one to the left (right-going half-edges are even and come first).
    if (star.count != 2 || (star.first & 1u) || !(star.second & 1u)) return;
    const Edge &right = raw_.edge(star.first / 2), &left = raw_.edge(star.second / 2);
    Mark m = raw_.vertex(v).mark;
    passes_[v] = right.mark == m && left.mark == m && same_curve(left, right);
  }

  void make_edges() {
    std::size_t kept = std::size_t(std::count(kept_.begin(), kept_.end(), 1));
    out_.edges.reserve(kept);
    first_part_.reserve(kept);
    last_part_.reserve(kept);
    starts_.assign(raw_.edge_count(), kNone);
    ends_.assign(raw_.edge_count(), kNone);
    for (Index e = 0; e < raw_.edge_count(); ++e) {
      if (!kept_[e] || passes_[raw_.edge(e).v0]) continue;
      Index last = e;
      while (passes_[raw_.edge(last).v1]) last = first_[raw_.edge(last).v1] / 2;
      starts_[e] = ends_[last] = Index(out_.edges.size());
      first_part_.push_back(e);
      last_part_.push_back(last);
      out_.edges.push_back(raw_.edge(e));
      out_.edges.back().v1 = raw_.edge(last).v1;
    }
  }

  Index new_half_edge(Index h) const { return h & 1u ? 2 * ends_[h / 2] + 1 : 2 * starts_[h / 2]; }

  void make_vertices() {
    ArenaVector<Index> number(raw_.vertex_count(), kNone, memory_);
    out_.vertices.reserve(raw_.vertex_count() - std::size_t(std::count(passes_.begin(), passes_.end(), 1)));
    for (Index v = 0; v < raw_.vertex_count(); ++v) {
      const Vertex& w = raw_.vertex(v);
      Vertex made{.point = w.point, .mark = w.mark, .out = kNone, .face = kNone};
      if (first_[v] == kNone) {
        Index f = w.out == kNone ? w.face : raw_.face(w.out);
        if (raw_.face_mark(f) == w.mark) continue;
        made.face = faces_.find(f);
      } else {
        if (passes_[v]) continue;
        made.out = new_half_edge(first_[v]);
      }
      number[v] = Index(out_.vertices.size());
      out_.vertices.push_back(made);
    }
    for (Edge& e : out_.edges) {
      e.v0 = number[e.v0];
      e.v1 = number[e.v1];
    }
  }

  Index next_kept(Index h) const {
    Index k = raw_.next(h);
    while (!kept(k)) k = raw_.next(k ^ 1u);
    return k;
  }

  void link() {
    out_.half_edges.resize(2 * out_.edges.size());
    for (Index e = 0; e < out_.edges.size(); ++e) {
      Index forward = 2 * last_part_[e], backward = 2 * first_part_[e] + 1;
      out_.half_edges[2 * e] = {new_half_edge(next_kept(forward)), faces_.find(raw_.face(forward))};
      out_.half_edges[2 * e + 1] = {new_half_edge(next_kept(backward)), faces_.find(raw_.face(backward))};
    }
  }

  void number_faces() {
    ArenaVector<Index> number(raw_.face_count(), kNone, memory_);
    auto use = [&](Index& f) {
      if (number[f] == kNone) {
        number[f] = Index(out_.faces.size());
        out_.faces.push_back(Face{.mark = raw_.face_mark(f), .outer = kNone, .inner = {}, .isolated = {}});
      }
      f = number[f];
    };
    Index unbounded = faces_.find(0);
    use(unbounded);
    for (HalfEdge& h : out_.half_edges) use(h.face);
    for (Index v = 0; v < out_.vertices.size(); ++v)
      if (out_.vertices[v].out == kNone) {
        use(out_.vertices[v].face);
        out_.faces[out_.vertices[v].face].isolated.push_back(v);
      }
  }

  /// The outer side of each connected component of edges is an inner boundary of the face around it.
  void collect_cycles() {
    UnionFind parts(out_.vertices.size(), memory_);
    for (const Edge& e : out_.edges) parts.unite(e.v0, e.v1);
    ArenaVector<Index> smallest(out_.vertices.size(), kNone, memory_);
    for (Index v = 0; v < out_.vertices.size(); ++v) {
      Index h = out_.vertices[v].out;
      if (h == kNone || (out_.clockwise(h) & 1u)) continue;  // has a half-edge to its left
      Index& s = smallest[parts.find(v)];
      if (s == kNone || compare_xy(geometry_, out_.vertices[v].point, out_.vertices[s].point) < 0) s = v;
    }
    ArenaVector<char> seen(out_.half_edges.size(), 0, memory_);
    auto walk = [&](Index h) {
      for (Index k = h; !seen[k]; k = out_.next(k)) seen[k] = 1;
    };
    for (Index v : smallest)
      if (v != kNone) {
        Index h = out_.clockwise(out_.vertices[v].out);
        out_.faces[out_.face(h)].inner.push_back(h);
        walk(h);
      }
    for (Index h = 0; h < out_.half_edges.size(); ++h)
      if (!seen[h]) {
        out_.faces[out_.face(h)].outer = h;
        walk(h);
      }
  }

  /// Keeps what is used where it stands, in order, so that crossings keep the order of their supporting curves.
  void compact_geometry() {
    exact::Geometry& g = geometry_;
    ArenaVector<Index> supporting_curve(g.supporting_curves.size(), 0, memory_), point(g.points.size(), 0, memory_);
    for (const Edge& e : out_.edges) supporting_curve[e.supporting_curve] = 1;
    for (const Vertex& v : out_.vertices) {
      const exact::Point& p = g.points[v.point];
      point[v.point] = 1;
      if (p.kind == exact::Point::Kind::kCross) supporting_curve[p.i] = supporting_curve[p.j] = 1;
    }
    keep_used(supporting_curve, g.supporting_curves);
    keep_used(point, g.points);
    exact::Geometry& to = out_.geometry;
    for (exact::Point& p : g.points) {
      if (p.kind == exact::Point::Kind::kCross) {
        p.i = supporting_curve[p.i];
        p.j = supporting_curve[p.j];
      }
      if (p.kind == exact::Point::Kind::kReal) {
        to.reals.push_back(g.reals[p.i]);
        p.i = Index(to.reals.size() - 1);
      }
    }
    empty_all(std::span(g.reals));
    to.supporting_curves = std::move(g.supporting_curves);
    to.points = std::move(g.points);
    for (Edge& e : out_.edges) e.supporting_curve = supporting_curve[e.supporting_curve];
    for (Vertex& v : out_.vertices) v.point = point[v.point];
  }

  const Cells raw_;
  exact::Geometry& geometry_;
  CellComplex out_;
  Memory memory_;
  UnionFind faces_;
  ArenaVector<char> kept_, passes_;            // per raw edge, per raw vertex
  ArenaVector<Index> first_;                   // raw vertex -> first kept half-edge
  ArenaVector<Index> starts_, ends_;           // raw edge -> the new edge it starts / ends
  ArenaVector<Index> first_part_, last_part_;  // new edge -> its first / last raw edge
};

}  // namespace

CellComplex simplify(CellComplex raw) {
  Arena arena(raw.edges.size());
  return Merger(ComplexCells{raw}, arena.memory()).run();
}

CellComplex extract(Arrangement&& a, const MarkViews& marks) {
  Arena arena(a.edges.size());
  return Merger(ArrangedCells{a, marks}, arena.memory()).run();
}

}  // namespace findspace::plane
