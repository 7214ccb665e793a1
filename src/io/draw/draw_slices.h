// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A region of space in layers: one panel for each height, seen from above, in which the lines along x that the region
// meets are drawn as strips of their spacing, places of length 0 as dots, and below them what the fixed shapes have at
// that height, each with its name. Guarantee: the ends of strips are those of the ray map; between its lines nothing is
// claimed. Cost: one strip an interval. Keywords: slicing, layers, contour.
#pragma once

#include <string>
#include <vector>

#include "space/rays/ray_map.h"

namespace findspace::io {

/// `layers` panels; lines along x, about n a panel. Row j of the grid is layer j.
space::RayGrid slice_grid(const space::Point& low, const space::Point& high, int layers, int n);

struct SlicesPicture {
  std::string title, subtitle, unit;
  std::string meaning;              // of what is drawn
  space::RayGrid grid;              // as slice_grid makes it
  space::Point low, high;           // the window
  double step = 1;                  // a grid step in the scene's unit
  std::vector<space::RayRow> rows;  // a row a layer, at most 0 in the region
  struct Fixed {
    std::string name;
    std::vector<space::RayRow> rows;  // as those of the region
  };
  std::vector<Fixed> fixed;
};

std::string slices_svg(const SlicesPicture& picture);

}  // namespace findspace::io
