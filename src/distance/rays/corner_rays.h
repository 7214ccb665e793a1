// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where on the lines of a grid all corners of a body are within a level of solids that are given by their surfaces: the
// lines of each corner meet one offset surface (space/convolution/ray_ball.h), which all share. A line is asked corner
// by corner, as long as something of it is left; the corner that ended the line before comes first, and one that boxes
// show to be within on all that is left is passed over. Guarantee: exact, whatever the order. Cost: some microseconds
// for each corner and line on which it does not stay within. Keywords: Minkowski erosion, configuration space.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_solids.h"
#include "space/polytope/extent.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

/// Of a closed stretch of a line: where it begins and ends; the same for a single place.
struct EventStretch {
  const space::RayEvent *first, *last;
};
/// What is not + on line i of a row.
std::vector<EventStretch> stretches_on(const space::RayRow& row, int i);

/// Closed stretches of lines: + outside, - inside, 0 at ends.
class LineStretches {
 public:
  virtual ~LineStretches() = default;
  /// Only of what is not + in `within`, if there is one.
  virtual exact::Tried<space::RayRow> try_row(int j, const space::RayRow* within) const = 0;
};

/// Where a source is not +.
std::unique_ptr<LineStretches> stretches_of(space::RaySourcePointer source);

/// `certain`: whether certainly each place of a box is within the level; in grid steps.
std::unique_ptr<LineStretches> corner_stretches(std::vector<space::Point> corners,
                                                const std::vector<space::RaySolid>& solids, const exact::Real& level,
                                                const space::RayGrid& grid,
                                                std::function<bool(const space::Extent&)> certain);

}  // namespace findspace::distance
