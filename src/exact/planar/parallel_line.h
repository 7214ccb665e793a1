// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The line through a grid point parallel to a grid line, for loops that make many, in which nothing is left to be
// called. Guarantee: exact, with certain error bounds. Cost: some nanoseconds.
#pragma once

#include <cmath>
#include <cstdint>

#include "exact/planar/geometry.h"

namespace findspace::exact {

/// The line through (x, y), which shares the filter of the given one.
inline SupportingCurve parallel_line(const SupportingCurve& line, std::int64_t x, std::int64_t y) {
  // The unit normal is off by at most 7u of it, the rounded coordinates, the products and the sum by u each.
  const double along_x = line.x().value * double(x), along_y = line.y().value * double(y);
  return {line, int128(line.a) * x + int128(line.b) * y, along_x + along_y,
          ErrorBound::units<11>(std::abs(along_x) + std::abs(along_y))};
}

}  // namespace findspace::exact
