// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/shape_pair.h"

#include <algorithm>
#include <cmath>

#include "distance/planar/derived.h"
#include "distance/planar/farthest.h"
#include "distance/planar/hausdorff.h"
#include "distance/planar_features/feature_pair_search.h"
#include "plane/base/real_vector.h"
#include "plane/complex/extent.h"
#include "plane/query/moved.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::operator-;

namespace {

constexpr double kFar = 16;  // times the size of the shapes

double size(const plane::PieceBox& b) { return std::max(b.x1 - b.x0, b.y1 - b.y0); }
RealPoint grid_middle(const plane::PieceBox& b) {
  return {Real(std::llround((b.x0 + b.x1) / 2)), Real(std::llround((b.y0 + b.y1) / 2))};
}
bool is_far(const plane::PieceBox& b, double size) {
  return std::max({std::abs(b.x0), std::abs(b.x1), std::abs(b.y0), std::abs(b.y1)}) > kFar * size;
}

}  // namespace

ShapePair::ShapePair(plane::SharedRegion b, plane::SharedRegion a) : b_(std::move(b)), a_(std::move(a)) {}

TDistancePointer ShapePair::distance(Which which) const {
  std::lock_guard lock(guard_);
  auto& slot = known_[std::size_t(which)];
  if (!slot) slot = made(which);
  return slot;
}

const std::optional<ShapePair::AtOrigin>& ShapePair::at_origin() const {
  std::call_once(moved_, [this] {
    const auto b = plane::extent(b_), a = plane::extent(a_);
    if (!a || !b) return;
    const double size = std::max({1.0, distance::size(*a), distance::size(*b)});
    if (!is_far(*a, size) && !is_far(*b, size)) return;
    const RealPoint to_b = grid_middle(*b), to_a = grid_middle(*a);
    at_origin_ = {std::make_shared<ShapePair>(plane::moved(b_, -to_b), plane::moved(a_, -to_a)), to_b - to_a, -to_a};
  });
  return at_origin_;
}

TDistancePointer ShapePair::searched(Which which) const {
  const auto& there = at_origin();
  return there ? displaced(there->pair->distance(which), there->by) : distance(which);
}

TDistancePointer ShapePair::farthest(Which base) const {
  return std::make_shared<Farthest>(static_cast<const SignedDistance&>(*distance(base)).base());
}

TDistancePointer ShapePair::diameter() const {
  auto gamma2 = distance(Which::kGamma2);
  if (!gamma2->defined()) return gamma2;
  const RealPoint origin{Real(), Real()};
  const FeatureTree a(a_), b(b_);
  return cut_off(gamma2, std::max(farthest_pair(a, a, origin).distance, farthest_pair(b, b, origin).distance));
}

TDistancePointer ShapePair::made(Which which) const {
  auto shared = [](SignedDistance d) { return std::make_shared<SignedDistance>(std::move(d)); };
  switch (which) {
    case Which::kGamma1:
      return shared(SignedDistance::gamma1(b_, a_));
    case Which::kEta1:
      return shared(SignedDistance::eta1(b_, a_));
    case Which::kDelta1:
      return shared(SignedDistance::delta1(b_, a_));
    case Which::kGamma2:
      return farthest(Which::kGamma1);
    case Which::kEta2:
      return farthest(Which::kEta1);
    case Which::kDelta2:
      return farthest(Which::kDelta1);
    case Which::kMu:
      return std::make_shared<DirectedHausdorff>(b_, a_);
    case Which::kMuBack:
      return reflected(std::make_shared<DirectedHausdorff>(a_, b_));
    case Which::kHausdorff:
      return greater(distance(Which::kMu), distance(Which::kMuBack));
    case Which::kD1:
      return cut_off(distance(Which::kGamma1), Real());
    case Which::kH:
      return cut_off(distance(Which::kMu), Real());
    case Which::kHBack:
      return cut_off(distance(Which::kMuBack), Real());
    case Which::kDstar:
      return cut_off(distance(Which::kDelta1), Real(), true);
    case Which::kDstarBack:
      return cut_off(distance(Which::kEta1), Real(), true);
    case Which::kDiameter:
      return diameter();
    case Which::kPenetration:
      return cut_off(distance(Which::kGamma1), Real(), true);
  }
  return nullptr;
}

}  // namespace findspace::distance
