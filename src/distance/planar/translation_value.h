// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values of distances along a direction at one position, from the signs of gamma1, eta1 or delta1 on the line through
// it (- in O, 0 in C \ O, + elsewhere; the position is t = 0): the same in the plane and in space. Where a search told
// the signs, 0 means that the sign is not known, and the value lies between those of two readings. Guarantee: exact.
// Source: distances.md 7.1.
#pragma once

#include <optional>

#include "plane/query/section.h"

namespace findspace::distance {

/// The place t that gives the value sign * |t|; or the value is minus infinity.
struct TranslationValue {
  exact::Real t;
  int sign = 0;
  bool lowest = false;

  exact::Real value() const { return exact::Real(sign) * abs(t); }
};

/// gamma1, eta1, delta1: by the nearest place where the answer changes; gamma2, eta2, delta2: by the farthest place of
/// C, which is bounded. Nothing: +infinity.
std::optional<TranslationValue> translation_value(const plane::Section& line, bool farthest, bool both_ways);

/// Of the value less a level.
int sign_of(const std::optional<TranslationValue>& value, const exact::Real& level);

/// What the value lies between. `farthest` distances without a lower end may be undefined.
struct TranslationBounds {
  std::optional<TranslationValue> lower, upper;

  /// 0 where it is not known.
  int sign(const exact::Real& level, bool farthest) const;
};
/// Of a line whose signs are not known where they are 0.
TranslationBounds translation_bounds(const plane::Section& line, bool farthest, bool both_ways);

}  // namespace findspace::distance
