// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_extreme.h"

#include <algorithm>
#include <cmath>

#include "space/rays/ray_intervals.h"

namespace findspace::space {
namespace {

std::array<double, 3> coordinates(const Point& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

}  // namespace

RayExtreme::RayExtreme(const RayAim& aim, const Point& low, const Point& high)
    : aim_(aim), low_(coordinates(low)), high_(coordinates(high)) {}

void RayExtreme::take(const std::array<double, 3>& at, bool in) {
  double value = 0;
  if (aim_.axis < 0) {
    for (std::size_t k = 0; k < 3; ++k) value += (at[k] - aim_.point[k]) * (at[k] - aim_.point[k]);
    value = std::sqrt(value);
  } else {
    value = at[static_cast<std::size_t>(aim_.axis)];
  }
  const bool better = !found_ || (aim_.greatest ? value > found_->value : value < found_->value);
  if (better || (in && !found_->attained && !(value < found_->value) && !(value > found_->value)))
    found_ = Found{value, at, in};
}

void RayExtreme::add(const RayGrid& grid, int j, const RayRow& row) {
  each_interval(grid, j, row, [&](const RayInterval& found) {
    std::array<double, 3> at = found.at;
    if (aim_.axis < 0) {
      const double near = std::clamp(aim_.point[found.axis], found.from, found.to);
      at[found.axis] = near;
      take(at, (near > found.from || found.from_in) && (near < found.to || found.to_in));
      return;
    }
    double from = found.from, to = found.to;
    cut_at(low_[found.axis], high_[found.axis], from, to);
    at[found.axis] = from;
    take(at, found.from_in);
    at[found.axis] = to;
    take(at, found.to_in);
  });
}

}  // namespace findspace::space
