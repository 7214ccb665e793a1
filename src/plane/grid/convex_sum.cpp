// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/convex_sum.h"

#include "plane/base/arena.h"
#include "plane/grid/one_ring.h"

namespace findspace::plane {
namespace {

bool upper(const GridCorner& c) { return c.dy > 0 || (c.dy == 0 && c.dx > 0); }

/// The corners in order from the first whose edge has an angle in [0, 180).
class ConvexRing {
 public:
  explicit ConvexRing(const ConvexOperand& o) : corners_(o.face.corners), geometry_(o.geometry) {
    while (upper(corners_[at_]) == upper(corners_[corners_[at_].before]) || !upper(corners_[at_])) ++at_;
  }

  bool ended() const { return taken_ == corners_.size(); }
  const GridCorner& corner() const { return corners_[at_]; }
  const exact::SupportingCurve& supporting_curve() const {
    return geometry_.supporting_curves[corner().supporting_curve];
  }
  void advance() {
    ++taken_;
    at_ = corner().next;
  }

 private:
  std::span<const GridCorner> corners_;
  const exact::Geometry& geometry_;
  std::size_t at_ = 0, taken_ = 0;
};

/// Order of the directions of the next edges, both rings begun at their first.
int order(const ConvexRing& p, const ConvexRing& q) {
  if (p.ended() || q.ended()) return p.ended() ? 1 : -1;
  const GridCorner &c = p.corner(), &d = q.corner();
  if (upper(c) != upper(d)) return upper(c) ? -1 : 1;
  exact::int128 cross = exact::int128(c.dx) * d.dy - exact::int128(c.dy) * d.dx;
  return (cross < 0) - (cross > 0);
}

}  // namespace

SignMap convex_sum(ConvexOperand a, ConvexOperand b) {
  ConvexRing p(a), q(b);
  std::size_t most = a.face.corners.size() + b.face.corners.size();
  exact::Geometry geometry;
  geometry.supporting_curves.reserve(most);
  geometry.points.reserve(most);
  Arena arena(most);
  ArenaVector<RingEdge> edges(arena.memory());
  edges.reserve(most);
  while (!p.ended() || !q.ended()) {
    // An edge of one ring starts at the sum of its start and of the corner where the other ring stands.
    GridPoint u = p.corner().at, v = q.corner().at;
    int o = order(p, q);
    const ConvexRing& side = o <= 0 ? p : q;
    const GridCorner& c = side.corner();
    Index supporting_curve = geometry.add_parallel(side.supporting_curve(), u.x + v.x, u.y + v.y);
    edges.push_back(
        {geometry.add_grid_point(u.x + v.x, u.y + v.y), supporting_curve, c.dx > 0 || (c.dx == 0 && c.dy > 0)});
    if (o <= 0) p.advance();
    if (o >= 0) q.advance();
  }
  return ring_complex(std::move(geometry), edges, kOneRing, kOpenSetSigns);
}

}  // namespace findspace::plane
