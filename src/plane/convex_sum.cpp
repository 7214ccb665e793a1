// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/convex_sum.h"

namespace findspace::plane {
namespace {

bool upper(const GridCorner& c) { return c.dy > 0 || (c.dy == 0 && c.dx > 0); }

/// The corners in order from the first whose edge has an angle in [0, 180).
class Ring {
 public:
  explicit Ring(const ConvexOperand& o) : corners_(o.face.corners), geometry_(o.geometry) {
    while (upper(corners_[at_]) == upper(corners_[corners_[at_].before]) || !upper(corners_[at_])) ++at_;
  }

  bool ended() const { return taken_ == corners_.size(); }
  const GridCorner& corner() const { return corners_[at_]; }
  const exact::Carrier& carrier() const { return geometry_.carriers[corner().carrier]; }
  void advance() { ++taken_, at_ = corner().next; }

 private:
  const std::vector<GridCorner>& corners_;
  const exact::Geometry& geometry_;
  std::size_t at_ = 0, taken_ = 0;
};

/// Order of the directions of the next edges, both rings begun at their first.
int order(const Ring& p, const Ring& q) {
  if (p.ended() || q.ended()) return p.ended() ? 1 : -1;
  const GridCorner &c = p.corner(), &d = q.corner();
  if (upper(c) != upper(d)) return upper(c) ? -1 : 1;
  exact::int128 cross = exact::int128(c.dx) * d.dy - exact::int128(c.dy) * d.dx;
  return (cross < 0) - (cross > 0);
}

/// A counter-clockwise convex ring as a complex, built edge by edge.
class RingBuilder {
 public:
  explicit RingBuilder(std::size_t edges) {
    map_.geometry.carriers.reserve(edges);
    map_.geometry.points.reserve(edges);
    map_.vertices.reserve(edges);
    map_.edges.reserve(edges);
  }

  /// A corner and the edge that leaves it along the ring of `side`.
  void add(GridPoint at, const Ring& side) {
    Index k = Index(map_.edges.size());
    const GridCorner& c = side.corner();
    bool right = c.dx > 0 || (c.dx == 0 && c.dy > 0);
    Index carrier = map_.geometry.add_parallel(side.carrier(), at.x, at.y);
    map_.vertices.push_back({.point = map_.geometry.add_grid_point(at.x, at.y), .mark = 0});
    map_.edges.push_back({.v0 = right ? k : k + 1, .v1 = right ? k + 1 : k, .carrier = carrier, .half = 0, .mark = 0});
  }

  SignMap finish() && {
    Index n = Index(map_.edges.size());
    Edge& last = map_.edges.back();
    (last.v0 == n ? last.v0 : last.v1) = 0;
    auto along = [&](Index k) { return 2 * k + (map_.edges[k].v0 == k ? 0 : 1); };
    map_.half_edges.resize(2 * n);
    for (Index k = 0; k < n; ++k) {
      Index next = k + 1 == n ? 0 : k + 1, h = along(k), g = along(next);
      map_.half_edges[h] = {.next = g, .face = 1};
      map_.half_edges[g ^ 1u] = {.next = h ^ 1u, .face = 0};
      // Counter-clockwise from the edge that leaves a corner to the one that enters it lies the inside; edges to the
      // right come first.
      Index back = h ^ 1u;
      map_.vertices[next].out = (g & 1u) > (back & 1u) ? back : g;
    }
    map_.faces = {Face{.mark = 1, .outer = kNone, .inner = {along(0) ^ 1u}, .isolated = {}},
                  Face{.mark = -1, .outer = along(0), .inner = {}, .isolated = {}}};
    return std::move(map_);
  }

 private:
  SignMap map_;
};

}  // namespace

SignMap convex_sum(ConvexOperand a, ConvexOperand b) {
  Ring p(a), q(b);
  RingBuilder ring(a.face.corners.size() + b.face.corners.size());
  while (!p.ended() || !q.ended()) {
    // An edge of one ring starts at the sum of its start and of the corner where the other ring stands.
    GridPoint u = p.corner().at, v = q.corner().at;
    int o = order(p, q);
    ring.add({u.x + v.x, u.y + v.y}, o <= 0 ? p : q);
    if (o <= 0) p.advance();
    if (o >= 0) q.advance();
  }
  return std::move(ring).finish();
}

}  // namespace findspace::plane
