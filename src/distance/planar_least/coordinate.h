// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least or greatest value of a linear form a*x + b*y over a set of positions, and the positions that have it:
// points and straight edges (distances.md 4.4, 6.2); a coordinate is such a form. Guarantee: exact; attained or not is
// decided from the marks. Cost: linear in the cells, one overlay. Keywords: bottom-left, extreme point, lexicographic
// minimum, support function.
#pragma once

#include <cstdint>

#include "distance/planar_least/extremum.h"

namespace findspace::distance {

/// The form a*x + b*y; (a, b) primitive: without a common factor, a > 0, or a = 0 and b = 1.
struct LinearForm {
  std::int64_t a = 0, b = 0;
};
inline constexpr LinearForm kX{1, 0}, kY{0, 1};

Extremum linear_extremum(const plane::Region& s, const LinearForm& form, Sense sense);

/// The positions of s where the form has this value.
plane::Region on_line(const plane::Region& s, const LinearForm& form, const exact::Real& value);

}  // namespace findspace::distance
