// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a place is beyond the plane of a facet (the line of an edge), to be compared without roots: the value of the
// form at the place over the length of its normal. Guarantee: exact.
#pragma once

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

}  // namespace findspace::space
