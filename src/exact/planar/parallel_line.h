// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Lines parallel to grid lines, made in great numbers where they stand, as the curves of a convolution are. Guarantee:
// the line is exact, and its filter certain. Cost: some products; no root. Keywords: translation.
#pragma once

#include "exact/planar/geometry_stages.h"

namespace findspace::exact {

/// Makes a curve that is new the line through the grid point (x, y) parallel to a grid line, whose filter it shares.
inline void set_parallel(SupportingCurve& l, const SupportingCurve& line, std::int64_t x, std::int64_t y) {
  const Approx normal_x = line.x(), normal_y = line.y();
  l.a = line.a;
  l.b = line.b;
  l.c = int128(line.a) * x + int128(line.b) * y;
  l.set_filter(normal_x, normal_y, distance_through(normal_x, normal_y, x, y));
}

}  // namespace findspace::exact
