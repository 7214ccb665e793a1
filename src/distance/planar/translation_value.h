// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values of distances along a direction at one position, from the signs of gamma1, eta1 or delta1 on the line through
// it (- in O, 0 in C \ O, + elsewhere; the position is t = 0): the same in the plane and in space. Guarantee: exact.
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
};

/// gamma1, eta1, delta1: the nearest place where the answer changes. Nothing: +infinity.
std::optional<TranslationValue> nearest_change(const plane::Section& line, bool both_ways);
/// gamma2, eta2, delta2: the farthest place of C, which is bounded. Nothing: +infinity.
std::optional<TranslationValue> farthest_place(const plane::Section& line, bool both_ways);

}  // namespace findspace::distance
