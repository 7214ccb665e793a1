// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The extremal coordinate, or the least distance to a point, over a region given on rays.
// Guarantee: of the places on the lines, to the rounding of a double; between the lines there may be better ones: a
// minimum is an upper bound of the true one.
#pragma once

#include <array>
#include <optional>

#include "space/rays/ray_map.h"

namespace findspace::space {

/// In grid steps.
struct RayAim {
  int axis = -1;                  // 0, 1, 2; -1: the distance to `point`
  bool greatest = false;          // of a coordinate
  std::array<double, 3> point{};  // to which the distance is least
};

class RayExtreme {
 public:
  /// Of a coordinate, intervals without end are cut at the box (grid steps).
  RayExtreme(const RayAim& aim, const Point& low, const Point& high);
  /// Rows of grids of any axis. Signs of at most 0 belong to the region.
  void add(const RayGrid& grid, int j, const RayRow& row);

  struct Found {
    double value = 0;
    std::array<double, 3> at{};
    bool attained = false;  // the place belongs to the region
  };
  /// Nothing where no line meets the region.
  const std::optional<Found>& found() const { return found_; }

 private:
  void take(const std::array<double, 3>& at, bool in);

  RayAim aim_;
  std::array<double, 3> low_, high_;
  std::optional<Found> found_;
};

}  // namespace findspace::space
