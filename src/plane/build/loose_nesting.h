// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which way rings most likely run and how they most likely lie in each other, where they may touch and cross a little:
// what a set by winding numbers begins with. Rings are cut where they come back to a corner. No guarantee: whoever
// uses the answer proves it (mended_rings.h). Cost: pairs of rings whose boxes meet, times the edges of the larger one.
// Keywords: even-odd nesting, polygon repair.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plane/contour/shape.h"

namespace findspace::plane {

/// A closed chain that passes no corner twice.
struct Loop {
  Contour edges;
  std::size_t ring = 0;    // of which it is a part
  double area = 0;         // in square grid steps, positive where it runs counter-clockwise
  std::size_t depth = 0;   // how many others go round it
  std::size_t within = 0;  // the smallest of those; itself where there are none
};

std::vector<Loop> loosely_nested(std::span<const Contour> rings);

}  // namespace findspace::plane
