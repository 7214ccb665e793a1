// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/contour/grid_points.h"

#include <fmt/format.h>

#include <cmath>

#include "findspace/error.h"

namespace findspace::plane {

Contour grid_contour(const Grid& grid, std::span<const std::array<double, 2>> points, const char* name,
                     RoundingLog& log) {
  constexpr auto kMost = static_cast<double>(Grid::kLimit);
  Contour out(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Grid::Steps x = grid.steps_near(points[k][0]), y = grid.steps_near(points[k][1]);
    if (x.error == 0 && y.error == 0 && std::abs(x.value) <= kMost && std::abs(y.value) <= kMost) {
      out[k].start = {static_cast<std::int64_t>(x.value), static_cast<std::int64_t>(y.value)};
      continue;
    }
    try {
      out[k].start = grid.nearest(points[k][0], points[k][1], log);
    } catch (const Error& e) {
      throw e.within(fmt::format("{}, vertex {}", name, k));
    }
  }
  return out;
}

}  // namespace findspace::plane
