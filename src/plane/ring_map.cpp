// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/ring_map.h"

#include <algorithm>
#include <utility>

#include "plane/around_vertex.h"
#include "plane/scratch.h"

namespace findspace::plane {
namespace {

/// What the rings use; carriers keep their order, as crossings need.
class UsedGeometry {
 public:
  UsedGeometry(exact::Geometry from, std::span<const RingEdge> edges, Memory memory)
      : carrier_(from.carriers.size(), 0, memory) {
    for (const RingEdge& e : edges) {
      carrier_[e.carrier] = 1;
      const exact::Point& p = from.points[e.point];
      if (p.kind == exact::Point::Kind::kCross) carrier_[p.i] = carrier_[p.j] = 1;
    }
    Index count = 0;
    for (Index& k : carrier_) k = k ? count++ : kNone;
    all_ = count == from.carriers.size() && edges.size() == from.points.size();
    all_ ? void(geometry_ = std::move(from)) : copy(from, edges, count);
  }

  exact::Geometry take() { return std::move(geometry_); }
  Index carrier(Index old) const { return carrier_[old]; }
  /// Of edge k, in the order of the edges unless all are used.
  Index point(std::span<const RingEdge> edges, Index k) const { return all_ ? edges[k].point : k; }

 private:
  void copy(const exact::Geometry& from, std::span<const RingEdge> edges, Index carriers) {
    geometry_.carriers.reserve(carriers);
    for (Index k = 0; k < carrier_.size(); ++k)
      if (carrier_[k] != kNone) geometry_.carriers.push_back(from.carriers[k]);
    geometry_.points.reserve(edges.size());
    for (const RingEdge& e : edges) {
      exact::Point& p = geometry_.points.emplace_back(from.points[e.point]);
      if (p.kind == exact::Point::Kind::kCross) p.i = carrier_[p.i], p.j = carrier_[p.j];
      if (p.kind == exact::Point::Kind::kReal) {
        geometry_.reals.push_back(from.reals[p.i]);
        p.i = Index(geometry_.reals.size() - 1);
      }
    }
  }

  std::pmr::vector<Index> carrier_;
  bool all_;
  exact::Geometry geometry_;
};

/// Of two half-edges at their origin, the first counter-clockwise from straight down, those to the right first.
bool is_first(const SignMap& map, Index vertex, Index h, Index k) {
  if ((h & 1u) != (k & 1u)) return !(h & 1u);
  return comes_before(map.geometry, map.vertices[vertex].point, h & 1u, map.heading(h), map.edges[h / 2].half,
                      map.heading(k));
}

Index face_count(std::span<const NestedRing> rings) {
  Index last = 0;
  for (const NestedRing& r : rings) last = std::max({last, r.inside, r.outside});
  return last + 1;
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

SignMap ring_map(exact::Geometry geometry, std::span<const RingEdge> edges, std::span<const NestedRing> rings,
                 bool unbounded) {
  Scratch scratch(geometry.carriers.size() / 4);
  SignMap map;
  UsedGeometry used(std::move(geometry), edges, scratch.memory());
  map.geometry = used.take();
  const Index n = Index(edges.size());
  map.vertices.resize(n);
  map.edges.reserve(n);
  map.half_edges.resize(2 * n);
  map.faces.assign(face_count(rings), Face{.mark = 1, .outer = kNone, .inner = {}, .isolated = {}});
  if (unbounded) map.faces[0].mark = -1;
  auto along = [&](Index k) { return 2 * k + (edges[k].right ? 0 : 1); };
  for (const RingEdge& e : edges) map.edges.push_back({.carrier = used.carrier(e.carrier), .half = e.half, .mark = 0});
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const NestedRing& ring = rings[r];
    const Index first = ring.start, end = r + 1 < rings.size() ? rings[r + 1].start : n;
    for (Index k = first; k < end; ++k) {
      const Index next = k + 1 == end ? first : k + 1, h = along(k), g = along(next), back = h ^ 1u;
      map.edges[k].v0 = edges[k].right ? k : next;
      map.edges[k].v1 = edges[k].right ? next : k;
      map.half_edges[h] = {.next = g, .face = ring.inside};
      map.half_edges[g ^ 1u] = {.next = back, .face = ring.outside};
      map.vertices[next] = {.point = used.point(edges, next), .mark = 0};
      map.vertices[next].out = is_first(map, next, g, back) ? g : back;
    }
    map.faces[ring.inside].mark = -1;
    const Index within = along(first), without = within ^ 1u;
    map.faces[ring.outer ? ring.inside : ring.outside].outer = ring.outer ? within : without;
    map.faces[ring.outer ? ring.outside : ring.inside].inner.push_back(ring.outer ? without : within);
  }
  return map;
}

}  // namespace findspace::plane
