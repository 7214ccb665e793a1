// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/transversal_sum.h"

#include <algorithm>
#include <utility>

#include "plane/grid/one_ring.h"
#include "plane/walk/outer_walks.h"
#include "plane/walk/point_between.h"

namespace findspace::plane {
namespace {

class TransversalSum {
 public:
  TransversalSum(ReducedConvolution& c, const InsideTest& inside, Memory memory)
      : c_(c),
        inside_(inside),
        curves_(c, memory),
        rings_(memory),
        starts_(memory),
        passed_(curves_.degenerate_vertices().count(), 0, memory),
        memory_(memory) {}

  std::optional<SignMap> run() {
    if (!find_rings() || has_slot() || has_lonely_point()) return std::nullopt;
    if (starts_.size() == 1) return ring_map(std::move(c_.geometry), rings_, kOneRing, kOpenSetSigns);
    return ring_map(std::move(c_.geometry), rings_, rings_of_one_face(starts_), kOpenSetSigns);
  }

 private:
  bool find_rings() {
    OuterWalks walks(curves_, memory_);
    Index first = leftmost();
    if (first == kNone) return false;
    auto outer = walks.walk({first, 0});
    if (outer.empty() || !add_ring(outer)) return false;
    for (auto walk = walks.next(); !walk.empty(); walk = walks.next())
      if (!is_inside(walk.front()) && !add_ring(walk)) return false;
    return true;
  }

  /// The curve that starts at the leftmost corner of the sum: it is part of the outer ring. Ends made by pruning lie
  /// inside.
  Index leftmost() const {
    const exact::Point* const points = c_.geometry.points.data();
    const exact::Point* least = nullptr;
    Index best = kNone;
    for (Index i = 0, n = curves_.size(); i < n; ++i) {
      const exact::Point& p = points[curves_.start(i)];
      if (p.kind != exact::Point::Kind::kGrid) continue;
      if (least != nullptr && (p.gx != least->gx ? p.gx > least->gx : p.gy >= least->gy)) continue;
      least = &p;
      best = i;
    }
    return best;
  }

  /// Is a part of a curve in the sum? If the face on its outer side is, or both its sides are inner sides, it may be.
  bool is_inside(CurvePart p) {
    return inside_(c_.geometry,
                   point_between(c_.geometry, curves_.supporting_curve(p.curve), curves_.start(p), curves_.end(p)));
  }

  /// Between two curves with opposite inner sides.
  bool has_slot() {
    const auto parts = curves_.parts_with_two_inner_sides();
    return std::any_of(parts.begin(), parts.end(), [&](CurvePart p) { return !is_inside(p); });
  }

  /// With nothing but the sum all round.
  bool has_lonely_point() {
    const DegenerateVertices& degenerate_vertices = curves_.degenerate_vertices();
    for (Index k = 0; k < degenerate_vertices.count(); ++k)
      if (passed_[k] == 0 && degenerate_vertices.is_surrounded(k) &&
          !inside_(c_.geometry, degenerate_vertices.point(k)))
        return true;
    return false;
  }

  /// False where the ring passes a degenerate vertex that a ring has passed before.
  bool add_ring(std::span<const CurvePart> walk) {
    starts_.push_back(Index(rings_.size()));
    if (rings_.empty()) rings_.reserve(walk.size());
    const bool degenerate = !curves_.degenerate_vertices().empty();
    const exact::SupportingCurve* before = &line(walk.front());
    for (std::size_t k = walk.size(); k-- > 0;) {
      const CurvePart p = walk[k];
      if (degenerate)
        if (const Index at = curves_.degenerate_before(p); at != kNone && passed_[at]++ > 0) return false;
      const exact::SupportingCurve* const next = &line(p);
      const bool straight = before->a == next->a && before->b == next->b;
      before = next;
      if (!straight) rings_.push_back({curves_.start(p), curves_.supporting_curve(p.curve), curves_.right(p.curve)});
    }
    return true;
  }

  const exact::SupportingCurve& line(const CurvePart& p) const {
    return c_.geometry.supporting_curves[curves_.supporting_curve(p.curve)];
  }

  ReducedConvolution& c_;
  const InsideTest& inside_;
  MeetingCurves curves_;
  ArenaVector<RingEdge> rings_;
  ArenaVector<Index> starts_;
  ArenaVector<int> passed_;  // degenerate vertex -> times a ring passed it
  Memory memory_;
};

}  // namespace

std::optional<SignMap> transversal_sum(ReducedConvolution& convolution, const InsideTest& inside) {
  if (convolution.pieces.empty()) return std::nullopt;
  Arena arena(convolution.pieces.size());
  return TransversalSum(convolution, inside, arena.memory()).run();
}

}  // namespace findspace::plane
