// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/line_signs.h"

#include "space/rays/oblique_line.h"

namespace findspace::distance {

using exact::Real;

PositionLine position_line(const space::RayGrid& grid, double part, int i, int j) {
  PositionLine out;
  const Real unit = Real::ratio(1, grid.parts);
  if (grid.oblique) {
    out.start = space::scaled(Real::from_double(part), grid.oblique->origin);
    out.unit = grid.oblique->frame[2];
    return out;
  }
  const Real scale = Real::from_double(part * static_cast<double>(grid.parts)) * unit;
  const auto axis = static_cast<std::size_t>(grid.axis);
  out.start[(axis + 1) % 3] = Real(grid.u_at(i)) * scale;
  out.start[(axis + 2) % 3] = Real(grid.v_at(j)) * scale;
  out.unit[axis] = Real(1);
  return out;
}

space::Vector line_direction(const space::RayGrid& grid) { return space::rounded(position_line(grid, 1, 0, 0).unit); }

void put_line(std::span<const SignStretch> known, double part, space::RayRow& row, int outer) {
  int before = outer;
  row.before.push_back(static_cast<std::int8_t>(outer));
  for (std::size_t k = 0; k < known.size();) {
    std::size_t next = k;
    while (next < known.size() && known[next].sign == known[k].sign) ++next;
    const int sign = known[k].sign;
    // Between - and + there always is a stretch of 0; at its ends the sign is 0, too.
    if (sign != before) {
      row.events.push_back({ray_place(known[k].from / part), 0, static_cast<std::int8_t>(sign)});
      before = sign;
    }
    k = next;
  }
  if (before != outer) row.events.push_back({ray_place(known.back().to / part), 0, static_cast<std::int8_t>(outer)});
  row.first.push_back(static_cast<int>(row.events.size()));
}

}  // namespace findspace::distance
