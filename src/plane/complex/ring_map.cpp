// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/ring_map.h"

#include <algorithm>
#include <utility>

#include "plane/base/append_made.h"
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

  /// Nothing was dropped: the numbers are as before.
  bool all() const { return all_; }
  Index supporting_curve(Index old) const { return supporting_curve_[old]; }
  Index point(Index old) const { return point_[old]; }

 private:
  static bool all_used(const ArenaVector<Index>& used) { return std::find(used.begin(), used.end(), 0u) == used.end(); }

  ArenaVector<Index> supporting_curve_, point_, real_;
  bool all_ = false;
};

/// Of two half-edges at their origin that both go right, or both left: the first counter-clockwise from straight down
/// or straight up.
[[gnu::noinline]] bool comes_first(const CellComplex& map, Index point, Index h, Index k) {
  const Edge &e = map.edges[h / 2], &f = map.edges[k / 2];
  if (e.half == 0 && f.half == 0)
    return line_comes_before(map.geometry.supporting_curves[e.supporting_curve],
                             map.geometry.supporting_curves[f.supporting_curve]);
  return comes_before(map.geometry, point, h & 1u, map.heading(h), e.half, map.heading(k));
}

/// The first of two half-edges at their origin counter-clockwise from straight down, those to the right first.
Index first_of(const CellComplex& map, Index point, Index h, Index k) {
  const bool turns = ((h ^ k) & 1u) == 0;
  return (turns ? comes_first(map, point, h, k) : !(h & 1u)) ? h : k;
}

Index face_count(std::span<const NestedRing> rings) {
  Index last = 0;
  for (const NestedRing& r : rings) last = std::max({last, r.inside, r.outside});
  return last + 1;
}

/// The half-edge that runs along the ring, edge k of all.
Index half_edge(std::span<const RingEdge> edges, Index k) { return 2 * k + (edges[k].right ? 0 : 1); }

/// Adds the edges `first` to `end` of all, those of a ring, with their half-edges and corners. `curve`, `point`: the
/// numbers of a ring edge's supporting curve and point.
template <class CurveOf, class PointOf>
void join_ring(CellComplex& c, std::span<const RingEdge> edges, Index first, Index end, const NestedRing& ring, Mark on,
               CurveOf curve, PointOf point) {
  append_made(c.edges, end - first, [=](std::size_t i) {
    const Index k = first + Index(i), to = k + 1 == end ? first : k + 1;
    const RingEdge& e = edges[k];
    return Edge{e.right ? k : to, e.right ? to : k, curve(e), e.half, on};
  });
  append_made(c.vertices, end - first, [=](std::size_t i) {
    return Vertex{point(edges[first + i]), on, kNone, kNone};
  });
  c.half_edges.resize(2 * std::size_t(end));
  HalfEdge* out = c.half_edges.data() + 2 * first;
  Vertex* corner = c.vertices.data() + first;
  Index before = half_edge(edges, end - 1), here = half_edge(edges, first);
  for (Index k = first; k < end; ++k, out += 2, ++corner) {
    const Index next = half_edge(edges, k + 1 == end ? first : k + 1), side = here & 1u, back = before ^ 1u;
    out[side] = {next, ring.inside};
    out[side ^ 1u] = {back, ring.outside};
    corner->out = first_of(c, corner->point, here, back);
    before = here;
    here = next;
  }
}

/// What the rings bound, with this geometry, in which curves and points have numbers of their own.
template <class CurveOf, class PointOf>
CellComplex joined(exact::Geometry&& geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                   RingMarks marks, bool unbounded, CurveOf curve, PointOf point) {
  CellComplex c{std::move(geometry), {}, {}, {}, {}};
  const Index n = Index(edges.size());
  c.vertices.reserve(n);
  c.edges.reserve(n);
  c.half_edges.reserve(2 * std::size_t(n));
  c.faces.resize(face_count(rings));
  for (Face& f : c.faces) f.mark = marks.outside;
  if (unbounded) c.faces[0].mark = marks.inside;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const NestedRing& ring = rings[r];
    const Index end = r + 1 < rings.size() ? rings[r + 1].start : n;
    join_ring(c, edges, ring.start, end, ring, marks.on, curve, point);
    c.faces[ring.inside].mark = marks.inside;
    const Index within = half_edge(edges, ring.start), without = within ^ 1u;
    c.faces[ring.outer ? ring.inside : ring.outside].outer = ring.outer ? within : without;
    c.faces[ring.outer ? ring.outside : ring.inside].inner.push_back(ring.outer ? without : within);
  }
  return c;
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

CellComplex ring_complex(exact::Geometry&& geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                         RingMarks marks, bool unbounded) {
  return joined(
      std::move(geometry), edges, rings, marks, unbounded, [](const RingEdge& e) { return e.supporting_curve; },
      [](const RingEdge& e) { return e.point; });
}

CellComplex ring_map(exact::Geometry&& geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                     RingMarks marks, bool unbounded) {
  Arena arena(geometry.supporting_curves.size() / 4);
  const UsedGeometry used(geometry, edges, arena.memory());
  if (used.all()) return ring_complex(std::move(geometry), edges, rings, marks, unbounded);
  return joined(
      std::move(geometry), edges, rings, marks, unbounded,
      [&](const RingEdge& e) { return used.supporting_curve(e.supporting_curve); },
      [&](const RingEdge& e) { return used.point(e.point); });
}

}  // namespace findspace::plane
