// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/contour/grid_points.h"

#include <fmt/format.h>

#include "findspace/error.h"

namespace findspace::plane {

Contour grid_contour(const Grid& grid, std::span<const std::array<double, 2>> points, const char* name,
                     RoundingLog& log) {
  Contour out(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    GridPoint& start = out[k].start;
    if (grid.whole_steps(points[k][0], start.x) && grid.whole_steps(points[k][1], start.y)) continue;
    try {
      start = grid.nearest(points[k][0], points[k][1], log);
    } catch (const Error& e) {
      throw e.within(fmt::format("{}, vertex {}", name, k));
    }
  }
  return out;
}

}  // namespace findspace::plane
