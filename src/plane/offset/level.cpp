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

/// Of a part, or of a set that is not made in parts.
SignMap distance_at_once(const Region& closed, const exact::Real& radius) {
  if (auto map = grid_offset(closed, is_in, radius)) return *std::move(map);
  return disc_contact(closed, radius);
}
SignMap distance_at_once(Region&& closed, const exact::Real& radius) {
  if (auto map = grid_offset(closed, is_in, radius, kOpenSetSigns, [&] { closed = {}; })) return *std::move(map);
  return disc_contact(std::move(closed), radius);
}

/// The base is copied where it is kept.
template <class Base>
SignMap outer_level(Base&& base, const exact::Real& level) {
  if (auto map = grid_offset(
          base, [](Mark m) { return m <= 0; }, level))
    return *std::move(map);
  return distance_at_once(remark(std::forward<Base>(base), [](Mark m) { return Mark(m <= 0); }), level);
}

template <class Base>
SignMap inner_level(Base&& base, const exact::Real& level) {
  if (auto map = grid_offset(base, [](Mark m) { return m >= 0; }, -level, {1, 0, -1})) return *std::move(map);
  return negated(distance_at_once(remark(std::forward<Base>(base), [](Mark m) { return Mark(m >= 0); }), -level));
}

/// Of a set that is outside far away: of each part by itself, where it is large. A level below 0 lies within its part.
template <class Set, class Make>
SignMap by_parts(Set&& set, const exact::Real& level, Make&& make) {
  const double far = std::max(0.0, level.interval().hi);
  if (auto map = made_in_batches(set, {-far, -far, far, far}, make)) return *std::move(map);
  return make(std::forward<Set>(set));
}

template <class Closed>
SignMap distance_of(Closed&& closed, const exact::Real& radius) {
  const auto make = [&](auto&& part) { return distance_at_once(std::forward<decltype(part)>(part), radius); };
  return is_in(closed.faces[0].mark) ? make(std::forward<Closed>(closed))
                                     : by_parts(std::forward<Closed>(closed), radius, make);
}

template <class Base>
SignMap level_of(Base&& base, const exact::Real& level) {
  const int side = level.sign();
  if (side == 0) return std::forward<Base>(base);
  const auto make = [&](auto&& part) {
    return side > 0 ? outer_level(std::forward<decltype(part)>(part), level)
                    : inner_level(std::forward<decltype(part)>(part), level);
  };
  return base.faces[0].mark > 0 ? by_parts(std::forward<Base>(base), level, make) : make(std::forward<Base>(base));
}

}  // namespace

SignMap distance_map(const Region& closed, const exact::Real& radius) { return distance_of(closed, radius); }
SignMap distance_map(Region&& closed, const exact::Real& radius) { return distance_of(std::move(closed), radius); }

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
