// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep B of a CsgPair is in A.

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "distance/csg/csg_depth.h"
#include "distance/csg/csg_pair.h"
#include "exact/number/margins.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::Vector;

const CsgDepth& CsgPair::depths() const {
  std::call_once(depths_made_, [this] { depths_ = std::make_shared<const CsgDepth>(*b_, parts_, size_); });
  return *depths_;
}

/// Minus the distance to the nearest position at which B is free of a tolerance, or in a obstacle, and so free of A.
std::optional<Answer> CsgPair::free_of_sets(const RealVector& p) const {
  std::optional<Answer> best;
  const auto take = [&](std::optional<Answer> v, bool negated) {
    if (!v || !v->proven) return;
    if (negated) v->value = -v->value;
    if (!best || best->value < v->value) best = std::move(v);
  };
  for (std::size_t k = 0; k < containers_.size(); ++k) {
    if (a_->containers[k].convex()) take(containers_[k]->value(Which::kGamma1, p), false);
  }
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (a_->obstacles[k].convex()) take(obstacles_[k]->value(Which::kEta1, p), true);
  }
  return best;
}

Answer CsgPair::overlapping(const RealVector& p) const {
  std::optional<Answer> known = free_of_sets(p);
  const Incumbent ask = [&]() -> std::optional<double> {
    if (!known) return std::nullopt;
    return -known->value.to_double();
  };
  const BoundaryPlace found = depths().nearest(space::rounded(p), ask);
  const double off = std::fabs(found.value - found.bound);
  if ((!found.found && !found.known) || off > margin::kMostFoundError * size_)
    throw Error(ErrorCode::kUnsupported,
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
