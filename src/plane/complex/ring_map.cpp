// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/ring_map.h"

#include <algorithm>
#include <utility>

#include "plane/base/arena.h"
#include "plane/complex/around_vertex.h"
#include "plane/complex/keep_used.h"

namespace findspace::plane {
namespace {

/// What the rings use of a geometry; supporting curves keep their order, as crossings need.
class UsedGeometry {
 public:
  UsedGeometry(exact::Geometry& g, std::span<const RingEdge> edges, Memory memory)
      : supporting_curve_(g.supporting_curves.size(), 0, memory),
        point_(g.points.size(), 0, memory),
        real_(g.reals.size(), 0, memory) {
    for (const RingEdge& e : edges) {
      supporting_curve_[e.supporting_curve] = point_[e.point] = 1;
      const exact::Point& p = g.points[e.point];
      if (p.kind == exact::Point::Kind::kCross) supporting_curve_[p.i] = supporting_curve_[p.j] = 1;
      if (p.kind == exact::Point::Kind::kReal) real_[p.i] = 1;
    }
    if ((all_ = all_used(supporting_curve_) && all_used(point_) && all_used(real_))) return;
    keep_used(supporting_curve_, g.supporting_curves);
    keep_used(point_, g.points);
    keep_used(real_, g.reals);
    for (exact::Point& p : g.points) {
      if (p.kind == exact::Point::Kind::kCross) {
        p.i = supporting_curve_[p.i];
        p.j = supporting_curve_[p.j];
      }
      if (p.kind == exact::Point::Kind::kReal) p.i = real_[p.i];
    }
  }

  Index supporting_curve(Index old) const { return all_ ? old : supporting_curve_[old]; }
  Index point(Index old) const { return all_ ? old : point_[old]; }

 private:
  static bool all_used(const std::pmr::vector<Index>& used) {
    return std::find(used.begin(), used.end(), 0u) == used.end();
  }

  std::pmr::vector<Index> supporting_curve_, point_, real_;
  bool all_ = false;
};

/// Of two half-edges at their origin, the first counter-clockwise from straight down, those to the right first.
bool is_first(const CellComplex& map, Index vertex, Index h, Index k) {
  if ((h & 1u) != (k & 1u)) return !(h & 1u);
  const Edge &e = map.edges[h / 2], &f = map.edges[k / 2];
  if (e.half == 0 && f.half == 0)
    return line_comes_before(map.geometry.supporting_curves[e.supporting_curve],
                             map.geometry.supporting_curves[f.supporting_curve]);
  return comes_before(map.geometry, map.vertices[vertex].point, h & 1u, map.heading(h), e.half, map.heading(k));
}

Index face_count(std::span<const NestedRing> rings) {
  Index last = 0;
  for (const NestedRing& r : rings) last = std::max({last, r.inside, r.outside});
  return last + 1;
}

/// Joins the edges, which have their supporting curves, to rings and faces. `point`: of a ring edge.
template <class PointOf>
void join_rings(CellComplex& c, std::span<const RingEdge> edges, std::span<const NestedRing> rings, RingMarks marks,
                bool unbounded, PointOf point) {
  const Index n = Index(edges.size());
  c.vertices.resize(n);
  c.half_edges.resize(2 * n);
  c.faces.resize(face_count(rings));
  for (Face& f : c.faces) f.mark = marks.outside;
  if (unbounded) c.faces[0].mark = marks.inside;
  auto along = [&](Index k) { return 2 * k + (edges[k].right ? 0 : 1); };
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const NestedRing& ring = rings[r];
    const Index first = ring.start, end = r + 1 < rings.size() ? rings[r + 1].start : n;
    Index before = end - 1, h = along(before);
    for (Index k = first; k < end; before = k++) {
      const Index g = along(k), back = h ^ 1u;
      (h & 1u ? c.edges[before].v0 : c.edges[before].v1) = k;
      (g & 1u ? c.edges[k].v1 : c.edges[k].v0) = k;
      c.half_edges[h] = {.next = g, .face = ring.inside};
      c.half_edges[g ^ 1u] = {.next = back, .face = ring.outside};
      c.vertices[k].point = point(edges[k]);
      c.vertices[k].mark = marks.on;
      c.vertices[k].out = is_first(c, k, g, back) ? g : back;
      h = g;
    }
    c.faces[ring.inside].mark = marks.inside;
    const Index within = along(first), without = within ^ 1u;
    c.faces[ring.outer ? ring.inside : ring.outside].outer = ring.outer ? within : without;
    c.faces[ring.outer ? ring.outside : ring.inside].inner.push_back(ring.outer ? without : within);
  }
}

}  // namespace

std::vector<NestedRing> rings_of_one_face(std::span<const Index> starts, bool unbounded) {
  std::vector<NestedRing> rings;
  rings.reserve(starts.size());
  for (Index r = 0; r < starts.size(); ++r) {
    const bool outer = r == 0 && !unbounded;
    rings.push_back({starts[r], unbounded ? 0u : 1u, outer ? 0 : r + 1, outer});
  }
  return rings;
}

CellComplex ring_complex(exact::Geometry geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                         RingMarks marks, bool unbounded) {
  CellComplex c;
  c.geometry = std::move(geometry);
  c.edges.reserve(edges.size());
  for (const RingEdge& e : edges)
    c.edges.push_back({.supporting_curve = e.supporting_curve, .half = e.half, .mark = marks.on});
  join_rings(c, edges, rings, marks, unbounded, [](const RingEdge& e) { return e.point; });
  return c;
}

CellComplex ring_map(exact::Geometry geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                     RingMarks marks, bool unbounded) {
  Arena arena(geometry.supporting_curves.size() / 4);
  CellComplex map;
  const UsedGeometry used(geometry, edges, arena.memory());
  map.geometry = std::move(geometry);
  map.edges.reserve(edges.size());
  for (const RingEdge& e : edges)
    map.edges.push_back(
        {.supporting_curve = used.supporting_curve(e.supporting_curve), .half = e.half, .mark = marks.on});
  join_rings(map, edges, rings, marks, unbounded, [&](const RingEdge& e) { return used.point(e.point); });
  return map;
}

}  // namespace findspace::plane
