// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/star_sum.h"

#include <utility>

#include "plane/base/arena.h"
#include "plane/complex/ring_map.h"
#include "plane/contour/star_shaped.h"

namespace findspace::plane {
namespace {

/// Curves run with the sum on their left.
class StarRing {
 public:
  StarRing(const ReducedConvolution& c, Memory memory) : c_(c), order_(memory), memory_(memory) {}

  /// Whether all curves follow each other, round once as seen from one point.
  bool closes() {
    const Index n = Index(c_.pieces.size());
    std::pmr::vector<Index> leaves(c_.geometry.points.size(), kNone, memory_);
    for (Index i = 0; i < n; ++i) {
      if (leaves[start(i)] != kNone) return false;
      leaves[start(i)] = i;
    }
    order_.reserve(n);
    for (Index i = 0; order_.size() < n; i = leaves[end(i)]) {
      if (i == kNone || (i == 0 && !order_.empty())) return false;
      order_.push_back(i);
    }
    if (leaves[end(order_.back())] != 0) return false;
    return star_shaped(n, [&](std::size_t k) {
             const exact::Point& p = c_.geometry.points[start(order_[k])];
             return GridPoint{p.gx, p.gy};
           }) > 0;
  }

  /// Without straight corners.
  std::pmr::vector<RingEdge> edges() const {
    std::pmr::vector<RingEdge> out(memory_);
    out.reserve(order_.size());
    Index before = order_.back();
    for (Index i : order_) {
      const exact::SupportingCurve &k = supporting_curve(before), &l = supporting_curve(i);
      if (k.a != l.a || k.b != l.b) out.push_back({start(i), c_.pieces[i].supporting_curve, c_.sides[i].left});
      before = i;
    }
    return out;
  }

 private:
  Index start(Index i) const { return c_.sides[i].left ? c_.pieces[i].p0 : c_.pieces[i].p1; }
  Index end(Index i) const { return c_.sides[i].left ? c_.pieces[i].p1 : c_.pieces[i].p0; }
  const exact::SupportingCurve& supporting_curve(Index i) const {
    return c_.geometry.supporting_curves[c_.pieces[i].supporting_curve];
  }

  const ReducedConvolution& c_;
  std::pmr::vector<Index> order_;
  Memory memory_;
};

}  // namespace

std::optional<SignMap> star_sum(ReducedConvolution& convolution) {
  if (convolution.pieces.empty()) return std::nullopt;
  if (convolution.geometry.points.size() != convolution.pieces.size()) return std::nullopt;  // of each starts a curve
  Arena arena(convolution.pieces.size());
  StarRing ring(convolution, arena.memory());
  if (!ring.closes()) return std::nullopt;
  const std::pmr::vector<RingEdge> edges = ring.edges();
  const Index start = 0;
  return ring_map(std::move(convolution.geometry), edges, rings_of_one_face(std::span(&start, 1)), kOpenSetSigns);
}

}  // namespace findspace::plane
