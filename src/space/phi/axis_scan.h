// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where lines along one axis lie within many planes. The planes are divided by their slope along the axis beforehand,
// so that a line takes two products a plane and no division. Guarantee: the same bits on every machine, as plane_scan.h
// has it. Cost: linear in the planes, eight at a time. Keywords: line clipping, upper envelope, lower envelope.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "space/phi/plane_scan.h"

namespace findspace::space {

/// Eight heights a x + b y + c over the plane of the other two axes, in their order.
struct HeightBlock {
  double a[8], b[8], c[8];
};

/// The planes about a convex set as seen along an axis. In blocks: the values of those along it, the ends of lines
/// where they fall, and the ends where they rise, times -1.
struct AxisPlanes {
  const HeightBlock* blocks = nullptr;
  std::uint32_t along = 0, falling = 0, rising = 0;  // how many blocks of each
};

/// Adds the blocks for axis 0, 1 or 2; their place is left open. A plane whose slope is not more than `level` counts as
/// along it.
AxisPlanes planes_on_axis(std::span<const PlaneBlock> planes, std::size_t axis, double level,
                          std::vector<HeightBlock>& blocks);

__attribute__((always_inline)) inline double highest_inline(const HeightBlock* blocks, std::size_t count, double x,
                                                            double y) {
  const Lanes zero{}, at_x = zero + x, at_y = zero + y;
  Lanes most = zero - std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < count; ++b) {
    const auto* row = reinterpret_cast<const StoredLanes*>(blocks + b);
    const Lanes value = (row[0] * at_x + row[1] * at_y) + row[2];
    most = value > most ? value : most;
  }
  Lanes other = __builtin_shufflevector(most, most, 4, 5, 6, 7, 0, 1, 2, 3);
  most = other > most ? other : most;
  other = __builtin_shufflevector(most, most, 2, 3, 0, 1, 6, 7, 4, 5);
  most = other > most ? other : most;
  other = __builtin_shufflevector(most, most, 1, 0, 3, 2, 5, 4, 7, 6);
  most = other > most ? other : most;
  return most[0];
}

__attribute__((always_inline)) inline LineStretch scan_axis_inline(const AxisPlanes& planes, double x, double y,
                                                                   double shallow) {
  const HeightBlock* falling = planes.blocks + planes.along;
  if (planes.along > 0 && highest_inline(planes.blocks, planes.along, x, y) >= -shallow) return {};
  return {highest_inline(falling, planes.falling, x, y),
          -highest_inline(falling + planes.falling, planes.rising, x, y)};
}

/// The coordinates on the axis at which the line over these other two is within the planes; crossed where it is
/// nowhere, and where one along it is not below -`shallow`. By the machine's widest registers.
LineStretch scan_axis(const AxisPlanes& planes, double x, double y, double shallow);
/// The same by the registers of one kind, which must be one of vector_units().
LineStretch scan_axis_on(VectorUnit unit, const AxisPlanes& planes, double x, double y, double shallow);

}  // namespace findspace::space
