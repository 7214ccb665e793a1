// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep B of a CsgPair is in A.

#include <algorithm>
#include <cmath>

#include "distance/csg/csg_depth.h"
#include "distance/csg/csg_pair.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::Vector;

exact::Tried<const CsgDepth*> CsgPair::depths() const {
  std::call_once(depths_made_, [this] {
    auto made = CsgDepth::make(*b_, parts_, size_);
    if (made)
      depths_ = *std::move(made);
    else
      no_depths_ = made.refusal();
  });
  if (no_depths_) return *no_depths_;
  return depths_.get();
}

/// Minus the distance to the nearest position at which B is free of a container, or in an obstacle, and so free of A.
TriedAnswer CsgPair::free_of_sets(const RealVector& p) const {
  std::optional<Answer> best;
  const auto take = [&](std::optional<Answer> v, bool negated) {
    if (!v || !v->proven) return;
    if (negated) v->value = -v->value;
    if (!best || best->value < v->value) best = std::move(v);
  };
  for (std::size_t k = 0; k < containers_.size(); ++k) {
    if (!a_->containers[k].convex()) continue;
    TriedAnswer v = containers_[k]->try_value(Which::kGamma1, p);
    if (!v) return v;
    take(*std::move(v), false);
  }
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (!a_->obstacles[k].convex()) continue;
    TriedAnswer v = obstacles_[k]->try_value(Which::kEta1, p);
    if (!v) return v;
    take(*std::move(v), true);
  }
  return best;
}

exact::Tried<Answer> CsgPair::overlapping(const RealVector& p) const {
  const exact::Tried<const CsgDepth*> depths = this->depths();
  if (!depths) return depths.refusal();
  TriedAnswer free = free_of_sets(p);
  if (!free) return free.refusal();
  std::optional<Answer> known = *std::move(free);
  const Incumbent ask = [&]() -> std::optional<double> {
    if (!known) return std::nullopt;
    return -known->value.to_double();
  };
  const BoundaryPlace found = (*depths)->nearest(space::rounded(p), ask);
  const double off = std::fabs(found.value - found.bound);
  if ((!found.found && !found.known) || off > margin::kMostFoundError * size_)
    return exact::Refusal(
        "how deep a shape is in one that round ones are cut out of was not found within the limit of the "
        "search");
  Answer out;
  out.value = -Real::from_double(found.value);
  out.nearest = space::real(found.place);
  out.proven = false;
  out.error = margin::kFoundError * size_ + off;
  if (!known || std::fabs((known->value - out.value).to_double()) > out.error) return out;  // no sign: the same value
  if (!known->nearest && found.found) known->nearest = out.nearest;
  return *std::move(known);
}

}  // namespace findspace::distance
