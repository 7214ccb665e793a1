// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/level.h"

#include <algorithm>
#include <utility>

#include "plane/base/result_store.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/offset/grid_offset.h"
#include "plane/query/in_batches.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace {

/// By arranging the whole convolution with a disc: {d < r} = C (+) int rK, {d <= r} = C (+) rK.
template <class Closed>
SignMap disc_contact(Closed&& closed, const exact::Real& radius) {
  if (closed.edges.empty() && closed.vertices.empty()) return CellComplex::uniform(closed.faces[0].mark > 0 ? -1 : 1);
  return contact_map(std::forward<Closed>(closed), region_of_disc(0, 0, radius));
}

}  // namespace

SignMap distance_map(const Region& closed, const exact::Real& radius) {
  if (auto map = grid_offset(closed, is_in, radius)) return *std::move(map);
  return disc_contact(closed, radius);
}

SignMap distance_map(Region&& closed, const exact::Real& radius) {
  if (auto map = grid_offset(closed, is_in, radius)) return *std::move(map);
  return disc_contact(std::move(closed), radius);
}

namespace {

/// The base is copied where it is kept.
template <class Base>
SignMap outer_level(Base&& base, const exact::Real& level) {
  if (auto map = grid_offset(
          base, [](Mark m) { return m <= 0; }, level))
    return *std::move(map);
  return distance_map(remark(std::forward<Base>(base), [](Mark m) { return Mark(m <= 0); }), level);
}

template <class Base>
SignMap level_of(Base&& base, const exact::Real& level) {
  int side = level.sign();
  if (side == 0) return std::forward<Base>(base);
  if (side > 0) {
    const double far = level.interval().hi;
    if (base.faces[0].mark > 0)
      if (auto map = made_in_batches(base, {-far, -far, far, far},
                                     [&](const SignMap& part) { return outer_level(part, level); }))
        return *std::move(map);
    return outer_level(std::forward<Base>(base), level);
  }
  if (auto map = grid_offset(base, [](Mark m) { return m >= 0; }, -level, {1, 0, -1})) return *std::move(map);
  return negated(distance_map(remark(std::forward<Base>(base), [](Mark m) { return Mark(m >= 0); }), -level));
}

}  // namespace

SignMap level_map(const SignMap& base, const exact::Real& level) { return level_of(base, level); }
SignMap level_map(SignMap&& base, const exact::Real& level) { return level_of(std::move(base), level); }

std::optional<SignMap> contact_level_in_batches(const Region& a, const Region& b, const exact::Real& level) {
  const auto box = extent(b);
  const bool bounded = is_out(a.faces[0].mark) && is_out(b.faces[0].mark);
  if (!bounded || !box || result_store() != nullptr) return std::nullopt;
  // A level below 0 lies within the base.
  const double far = std::max(0.0, level.interval().hi);
  const PieceBox reach{-box->x1 - far, -box->y1 - far, far - box->x0, far - box->y0};
  const SumOperand moving(b);
  return made_in_batches(a, reach,
                         [&](const Region& part) { return level_map(contact_map(SumOperand(part), moving), level); });
}

}  // namespace findspace::plane
