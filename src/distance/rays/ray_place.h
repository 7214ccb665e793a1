// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A place along a ray that a search found: the double itself, as a fraction. Guarantee: what is below 2^-62 is lost.
#pragma once

#include <algorithm>
#include <cmath>

#include "space/rays/ray_map.h"

namespace findspace::distance {

inline space::RayPosition ray_place(double z) {
  int exponent = 0;
  const double mantissa = std::frexp(z, &exponent);
  const int down = std::clamp(53 - exponent, 0, 62);
  const auto numerator = static_cast<exact::int128>(std::ldexp(mantissa, exponent + down));
  space::RayPosition at;
  at.exact = exact::reduced({numerator, exact::int128(1) << down});
  at.value = exact::to_double(at.exact);
  return at;
}

}  // namespace findspace::distance
