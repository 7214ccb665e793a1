// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/star_sum.h"

#include <span>
#include <utility>

#include "plane/base/arena.h"
#include "plane/contour/star_shaped.h"
#include "plane/grid/one_ring.h"

namespace findspace::plane {
namespace {

/// Curves run with the sum on their left.
class StarRing {
 public:
  StarRing(const ReducedConvolution& c, Memory memory) : c_(c), ring_(memory), memory_(memory) {}

  /// Whether all curves follow each other, round once as seen from one point. Each of them starts at its own point.
  bool closes() {
    const Index n = Index(c_.pieces.size());
    const Piece* const pieces = c_.pieces.data();
    const InnerSide* const sides = c_.sides.data();
    ArenaVector<Index> leaving(n, kNone, memory_);
    Index* const leaves = leaving.data();
    for (Index i = 0; i < n; ++i) {
      const Index start = sides[i].left ? pieces[i].p0 : pieces[i].p1;
      if (leaves[start] != kNone) return false;
      leaves[start] = i;
    }
    ring_.resize(n);
    RingEdge* const ring = ring_.data();
    Index i = 0;
    for (Index k = 0; k < n; ++k) {
      if (i == 0 && k > 0) return false;
      const Piece& piece = pieces[i];
      const bool right = sides[i].left;
      ring[k] = {right ? piece.p0 : piece.p1, piece.supporting_curve, right};
      i = leaves[right ? piece.p1 : piece.p0];
    }
    const auto corner = [ring, points = c_.geometry.points.data()](std::size_t k) {
      const exact::Point& p = points[ring[k].point];
      return GridPoint{p.gx, p.gy};
    };
    return i == 0 && star_shaped(n, corner) > 0;
  }

  /// Without straight corners.
  std::span<const RingEdge> edges() {
    const exact::SupportingCurve* const lines = c_.geometry.supporting_curves.data();
    RingEdge* end = ring_.data();
    const exact::SupportingCurve* before = &lines[ring_.back().supporting_curve];
    for (const RingEdge& e : ring_) {
      const exact::SupportingCurve* const next = &lines[e.supporting_curve];
      if (before->a != next->a || before->b != next->b) *end++ = e;
      before = next;
    }
    return {ring_.data(), end};
  }

 private:
  const ReducedConvolution& c_;
  ArenaVector<RingEdge> ring_;
  Memory memory_;
};

}  // namespace

std::optional<SignMap> star_sum(ReducedConvolution& convolution) {
  if (convolution.pieces.empty()) return std::nullopt;
  if (convolution.geometry.points.size() != convolution.pieces.size()) return std::nullopt;  // of each starts a curve
  Arena arena(convolution.pieces.size());
  StarRing ring(convolution, arena.memory());
  if (!ring.closes()) return std::nullopt;
  const std::span<const RingEdge> edges = ring.edges();
  const bool all = edges.size() == convolution.pieces.size();  // their lines and points
  return (all ? ring_complex : ring_map)(std::move(convolution.geometry), edges, kOneRing, kOpenSetSigns, false);
}

}  // namespace findspace::plane
