// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/star_sum.h"

#include <span>
#include <utility>

#include "plane/base/arena.h"
#include "plane/complex/ring_map.h"
#include "plane/contour/star_shaped.h"

namespace findspace::plane {
namespace {

/// Curves run with the sum on their left.
class StarRing {
 public:
  StarRing(const ReducedConvolution& c, Memory memory) : c_(c), ring_(memory), memory_(memory) {}

  /// Whether all curves follow each other, round once as seen from one point. Each of them starts at its own point.
  bool closes() {
    const Index n = Index(c_.pieces.size());
    std::pmr::vector<Index> leaves(n, kNone, memory_);
    for (Index i = 0; i < n; ++i) {
      const Piece& piece = c_.pieces[i];
      Index& leaving = leaves[c_.sides[i].left ? piece.p0 : piece.p1];
      if (leaving != kNone) return false;
      leaving = i;
    }
    std::pmr::vector<GridPoint> corners(n, memory_);
    ring_.resize(n);
    Index i = 0;
    for (Index k = 0; k < n; ++k) {
      if (i == 0 && k > 0) return false;
      const Piece& piece = c_.pieces[i];
      const bool right = c_.sides[i].left;
      const Index start = right ? piece.p0 : piece.p1;
      const exact::Point& p = c_.geometry.points[start];
      corners[k] = {p.gx, p.gy};
      ring_[k] = {start, piece.supporting_curve, right};
      i = leaves[right ? piece.p1 : piece.p0];
    }
    return i == 0 && star_shaped(n, [&](std::size_t k) { return corners[k]; }) > 0;
  }

  /// Without straight corners.
  std::span<const RingEdge> edges() {
    RingEdge* end = ring_.data();
    const exact::SupportingCurve* before = &line(ring_.back());
    for (const RingEdge& e : ring_) {
      const exact::SupportingCurve* const next = &line(e);
      if (before->a != next->a || before->b != next->b) *end++ = e;
      before = next;
    }
    return {ring_.data(), end};
  }

 private:
  const exact::SupportingCurve& line(const RingEdge& e) const {
    return c_.geometry.supporting_curves[e.supporting_curve];
  }

  const ReducedConvolution& c_;
  std::pmr::vector<RingEdge> ring_;
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
  const Index start = 0;
  return ring_map(std::move(convolution.geometry), edges, rings_of_one_face(std::span(&start, 1)), kOpenSetSigns);
}

}  // namespace findspace::plane
