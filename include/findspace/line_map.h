// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions of space that have no exact form, on many parallel lines (docs/commands.md, "In 3D"). The lines run through
// the middle of square cells that cover the region. Guarantee: on each line exact, or found by a search where `exact`
// says no; of what lies between the lines nothing is said, but by volume bounds, which hold for the region itself: they
// count the cells around the lines that certainly belong, and those that possibly do. Cost: one convolution a pair of
// solids, then a fraction of a millisecond a line; for volume bounds twice that. Keywords: ray representation, dexel,
// voxel volume.
#pragma once

#include <optional>
#include <vector>

#include "findspace/number.h"
#include "findspace/shape.h"
#include "findspace/space_region.h"
#include "findspace/values.h"

namespace findspace {

/// Which lines.
struct Lines {
  int count = 64;                      // each way, from 1 to 16384
  Shape::Axis axis = Shape::Axis::kZ;  // along which they run
};

/// A region on lines.
struct LineMap {
  /// A line that meets the region.
  struct Line {
    Position3 through{};              // a point of it; its coordinate along the axis is 0
    std::vector<Interval> intervals;  // by that coordinate, in order
  };
  std::vector<Line> lines;                     // none: no line meets the region
  bool exact = true;                           // else ends are found by a search, off by at most 2^-30 of the sizes
  bool unbounded = false;                      // the region goes on for ever
  double volume = 0;                           // about: cells times lengths, as far as the window about the shapes
  std::size_t components = 0;                  // about: intervals of neighbouring lines that overlap are one
  std::optional<SpaceRegion::Bounds3> bounds;  // of what the lines meet in that window
};

/// The volume of a region of space, between bounds that hold but for the rounding of a sum; infinity where it is
/// unbounded.
struct VolumeBounds {
  /// Not more, and not less, than the volume.
  double lower = 0, upper = 0;
};

}  // namespace findspace
