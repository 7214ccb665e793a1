// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep B of a CsgSide is in A.

#include "distance/csg/csg_pair.h"
#include "distance/csg/csg_positions.h"

namespace findspace::distance {

using space::RealVector;

exact::Tried<const PositionSet*> CsgSide::free() const {
  std::call_once(free_made_, [this] {
    exact::Tried<PositionSet> made = free_positions(*b_, parts_, size_);
    if (made)
      free_ = *std::move(made);
    else
      no_free_ = made.refusal();
  });
  if (no_free_) return *no_free_;
  return &*free_;
}

/// The distance to the nearest position at which B is free of a container, or in an obstacle, and so free of A.
TriedAnswer CsgSide::free_of_sets(const RealVector& p) const {
  std::optional<Answer> best;
  const auto take = [&](std::optional<Answer> v, bool negated) {
    if (!v || !v->proven) return;
    if (negated) v->value = -v->value;
    if (!best || v->value < best->value) best = std::move(v);
  };
  for (std::size_t k = 0; k < containers_.size(); ++k) {
    if (!a_->containers[k].convex()) continue;
    TriedAnswer v = containers_[k].try_value(Which::kGamma1, p);
    if (!v) return v;
    take(*std::move(v), true);
  }
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (!a_->obstacles[k].convex()) continue;
    TriedAnswer v = obstacles_[k].try_value(Which::kEta1, p);
    if (!v) return v;
    take(*std::move(v), false);
  }
  return best;
}

TriedAnswer CsgSide::overlapping(const RealVector& p) const {
  const exact::Tried<const PositionSet*> free = this->free();
  if (!free) return free.refusal();
  const TriedAnswer known = free_of_sets(p);
  if (!known) return known;
  TriedAnswer found = (*free)->nearest(p, true, [&] { return *known; });
  if (!found) return found;
  return minus(**std::move(found));
}

}  // namespace findspace::distance
