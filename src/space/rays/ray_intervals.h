// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The intervals in which the lines of a row meet a region (signs of at most 0), one after another, each with its ends
// in or out; single places have from = to. Guarantee: places to the rounding of a double, in grid steps.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "space/rays/ray_map.h"

namespace findspace::space {

/// The points `at` with coordinate `axis` from `from` to `to`, which may be infinite.
struct RayInterval {
  std::array<double, 3> at{};
  std::size_t axis = 2;
  double from = 0, to = 0;
  bool from_in = false, to_in = false;
};

/// An end that is infinite goes to the box from `low` to `high`, or to the other end where that is beyond it.
inline void cut_at(double low, double high, double& from, double& to) {
  if (!std::isfinite(from)) from = std::min(low, to);
  if (!std::isfinite(to)) to = std::max(high, from);
}

template <class Visit>
void each_interval(const RayGrid& grid, int j, const RayRow& row, const Visit& visit) {
  const auto parts = static_cast<double>(grid.parts);
  RayInterval found;
  found.axis = static_cast<std::size_t>(grid.axis);
  found.at[(found.axis + 2) % 3] = static_cast<double>(grid.v_at(j)) / parts;
  for (int i = 0; i < grid.nu; ++i) {
    const auto line = static_cast<std::size_t>(i);
    found.at[(found.axis + 1) % 3] = static_cast<double>(grid.u_at(i)) / parts;
    bool in = row.before[line] <= 0;
    const auto begin = [&](double from, bool from_in) {
      found.from = from;
      found.from_in = from_in;
    };
    const auto end = [&](double to, bool to_in) {
      found.to = to;
      found.to_in = to_in;
      visit(found);
    };
    begin(-std::numeric_limits<double>::infinity(), false);
    for (int e = row.first[line]; e < row.first[line + 1]; ++e) {
      const RayEvent& event = row.events[static_cast<std::size_t>(e)];
      const bool here = event.here <= 0, after = event.after <= 0;
      const double place = event.at.value / parts;
      if (in && !(here && after)) end(place, here);
      if (!in && here && !after) {
        begin(place, true);
        end(place, true);
      }
      // A place that belongs to the interval before does not to the next.
      if (after && !(in && here)) begin(place, here && !in);
      in = after;
    }
    if (in) end(std::numeric_limits<double>::infinity(), false);
  }
}

}  // namespace findspace::space
