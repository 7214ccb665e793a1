// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/ray_extreme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace findspace::space {

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

void RayExtreme::take_interval(std::array<double, 3> at, std::size_t axis, double from, bool from_in, double to,
                               bool to_in) {
  if (aim_.axis < 0) {
    const double near = std::clamp(aim_.point[axis], from, to);
    at[axis] = near;
    take(at, (near > from || from_in) && (near < to || to_in));
    return;
  }
  if (std::isfinite(from)) at[axis] = from, take(at, from_in);
  if (std::isfinite(to)) at[axis] = to, take(at, to_in);
}

void RayExtreme::add(const RayGrid& grid, int j, const RayRow& row) {
  const auto axis = static_cast<std::size_t>(grid.axis);
  const auto parts = static_cast<double>(grid.parts);
  std::array<double, 3> at{};
  at[(axis + 2) % 3] = static_cast<double>(grid.v_at(j)) / parts;
  for (int i = 0; i < grid.nu; ++i) {
    const auto line = static_cast<std::size_t>(i);
    at[(axis + 1) % 3] = static_cast<double>(grid.u_at(i)) / parts;
    bool in = row.before[line] <= 0, from_in = false;
    double from = -std::numeric_limits<double>::infinity();
    for (int e = row.first[line]; e < row.first[line + 1]; ++e) {
      const RayEvent& event = row.events[static_cast<std::size_t>(e)];
      const bool here = event.here <= 0, after = event.after <= 0;
      const double place = event.at.value / parts;
      if (in && !(here && after)) take_interval(at, axis, from, from_in, place, here);
      if (!in && here && !after) take_interval(at, axis, place, true, place, true);
      if (after && !(in && here)) from = place, from_in = here;
      in = after;
    }
    if (in) take_interval(at, axis, from, from_in, std::numeric_limits<double>::infinity(), false);
  }
}

}  // namespace findspace::space
