// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/ring_map.h"

#include "plane/scratch.h"

namespace findspace::plane {
namespace {

/// Copies what the rings use; carriers keep their order, as crossings need.
class UsedGeometry {
 public:
  UsedGeometry(const exact::Geometry& from, std::span<const RingEdge> edges, exact::Geometry& to, Memory memory)
      : carrier_(from.carriers.size(), 0, memory) {
    for (const RingEdge& e : edges) {
      carrier_[e.carrier] = 1;
      const exact::Point& p = from.points[e.point];
      if (p.kind == exact::Point::Kind::kCross) carrier_[p.i] = carrier_[p.j] = 1;
    }
    Index count = 0;
    for (Index& k : carrier_) k = k ? count++ : kNone;
    to.carriers.reserve(count);
    for (Index k = 0; k < carrier_.size(); ++k)
      if (carrier_[k] != kNone) to.carriers.push_back(from.carriers[k]);
    to.points.reserve(edges.size());
    for (const RingEdge& e : edges) {
      exact::Point& p = to.points.emplace_back(from.points[e.point]);
      if (p.kind == exact::Point::Kind::kCross) p.i = carrier_[p.i], p.j = carrier_[p.j];
    }
  }

  Index carrier(Index old) const { return carrier_[old]; }

 private:
  std::pmr::vector<Index> carrier_;
};

/// +1 where the second of two successive edges turns left.
int turn(const exact::Geometry& g, const RingEdge& e, const RingEdge& f) {
  const exact::Carrier &k = g.carriers[e.carrier], &l = g.carriers[f.carrier];
  exact::int128 cross = exact::int128(k.a) * l.b - exact::int128(k.b) * l.a;
  int sign = (cross > 0) - (cross < 0);
  return ((k.b > 0) == e.right) == ((l.b > 0) == f.right) ? sign : -sign;
}

}  // namespace

SignMap ring_map(const exact::Geometry& geometry, std::span<const RingEdge> edges, std::span<const Index> starts) {
  Scratch scratch(geometry.carriers.size() / 4);
  SignMap map;
  UsedGeometry used(geometry, edges, map.geometry, scratch.memory());
  Index n = Index(edges.size());
  map.vertices.resize(n);
  map.edges.reserve(n);
  map.half_edges.resize(2 * n);
  map.faces.reserve(starts.size() + 1);
  map.faces = {Face{.mark = 1, .outer = kNone, .inner = {}, .isolated = {}},
               Face{.mark = -1, .outer = kNone, .inner = {}, .isolated = {}}};
  for (std::size_t r = 0; r < starts.size(); ++r) {
    Index first = starts[r], end = r + 1 < starts.size() ? starts[r + 1] : n;
    Index outside = r == 0 ? 0 : Index(map.faces.size());
    auto along = [&](Index k) { return 2 * k + (edges[k].right ? 0 : 1); };
    for (Index k = first; k < end; ++k) {
      Index next = k + 1 == end ? first : k + 1, h = along(k), g = along(next), back = h ^ 1u;
      bool right = edges[k].right;
      map.edges.push_back({.v0 = right ? k : next,
                           .v1 = right ? next : k,
                           .carrier = used.carrier(edges[k].carrier),
                           .half = 0,
                           .mark = 0});
      map.half_edges[h] = {.next = g, .face = 1};
      map.half_edges[g ^ 1u] = {.next = back, .face = outside};
      // Edges to the right come first; of two on the same side, at a left turn the one that leaves.
      bool leaving = (g & 1u) != (back & 1u) ? !(g & 1u) : turn(geometry, edges[k], edges[next]) > 0;
      map.vertices[next] = {.point = next, .mark = 0, .out = leaving ? g : back};
    }
    if (r == 0) {
      map.faces[1].outer = along(first);
      map.faces[0].inner.push_back(along(first) ^ 1u);
    } else {
      map.faces[1].inner.push_back(along(first));
      map.faces.push_back(Face{.mark = 1, .outer = along(first) ^ 1u, .inner = {}, .isolated = {}});
    }
  }
  return map;
}

}  // namespace findspace::plane
