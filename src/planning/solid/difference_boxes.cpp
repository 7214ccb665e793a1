// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/solid/difference_boxes.h"

namespace findspace::planning {

using exact::Real;

DifferenceBoxes::DifferenceBoxes(std::size_t positions) : size_(positions), bounds_(3 * positions * positions) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < size_; ++i) at(axis, i, i) = {Real(), true};
}

bool DifferenceBoxes::is_tighter(const Bound& a, const Bound& b) {
  if (!a.most || !b.most) return a.most.has_value();
  const int order = compare(*a.most, *b.most);
  return order < 0 || (order == 0 && !a.in && b.in);
}

DifferenceBoxes::Bound DifferenceBoxes::joined(const Bound& a, const Bound& b) {
  if (!a.most || !b.most) return {};
  return {*a.most + *b.most, a.in && b.in};
}

/// With every path that takes the new bound.
void DifferenceBoxes::limit(std::size_t axis, std::size_t i, std::size_t j, const Bound& bound) {
  if (empty_ || !is_tighter(bound, at(axis, i, j))) return;
  const Bound round = joined(bound, at(axis, j, i));
  if (round.most && (round.most->sign() < 0 || (round.most->sign() == 0 && !round.in))) {
    empty_ = true;
    return;
  }
  for (std::size_t u = 0; u < size_; ++u) {
    const Bound first = joined(at(axis, u, i), bound);
    for (std::size_t v = 0; v < size_ && first.most; ++v) {
      const Bound whole = joined(first, at(axis, j, v));
      if (u != v && is_tighter(whole, at(axis, u, v))) at(axis, u, v) = whole;
    }
  }
}

void DifferenceBoxes::demand(std::size_t i, std::size_t j, const space::IntervalBox& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const space::Interval& k = box[axis];
    if (k.to) limit(axis, i, j, {*k.to, k.to_in});
    if (k.from) limit(axis, j, i, {-*k.from, k.from_in});
  }
}

space::IntervalBox DifferenceBoxes::range(std::size_t i, std::size_t j) const {
  space::IntervalBox out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Bound &high = at(axis, i, j), &low = at(axis, j, i);
    space::Interval& k = out[axis];
    if (high.most) {
      k.to = *high.most;
      k.to_in = high.in;
    }
    if (low.most) {
      k.from = -*low.most;
      k.from_in = low.in;
    }
  }
  return out;
}

}  // namespace findspace::planning
