// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a place is beyond the plane of a facet (the line of an edge), to be compared without roots: the value of the
// form at the place over the length of its normal. Guarantee: exact. And roots of exact squares as doubles.
#pragma once

#include <findspace/error.h>

#include <cmath>
#include <initializer_list>

#include "exact/number/real.h"

namespace findspace::space {

struct Level {
  exact::Real value, square;  // of the form; of the length of its normal
};

/// The sign of a.value / sqrt(a.square) - b.value / sqrt(b.square).
inline int compare_levels(const Level& a, const Level& b) {
  const int s = a.value.sign(), t = b.value.sign();
  if (s != t) return s < t ? -1 : 1;
  return s * compare(a.value * a.value * b.square, b.value * b.value * a.square);
}

/// Relative error at most 2^-51, also where the square is too small for a double.
inline double root(const exact::Real& square) {
  const double rounded = square.to_double();
  return std::isnormal(rounded) || square.sign() == 0 ? std::sqrt(rounded) : sqrt(square).to_double();
}

/// Error(kBadValue) for a position (grid steps) whose distances have squares that are not doubles, or none itself.
inline void check_position(std::initializer_list<double> u) {
  constexpr double kFarthest = 0x1p500;  // no sign: the range of doubles
  for (const double c : u)
    if (!(std::fabs(c) <= kFarthest)) throw Error(ErrorCode::kBadValue, "a position is at most 2^500 grid steps away");
}

}  // namespace findspace::space
