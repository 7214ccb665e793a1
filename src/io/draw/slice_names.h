// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the names of fixed shapes stand in the layers of a map in space: on a shape's section where it has room, else
// beside it, off other names and as much as may be off the region and other sections. A shape that fills the layers is
// named in one of them only. A name that finds no free place is left out of that layer. Cost: the cells of a panel
// times the places tried. Keywords: label placement.
#pragma once

#include <string>
#include <vector>

#include "io/draw/draw_canvas.h"

namespace findspace::io {

/// An interval of a line along x, in the scene's unit; from = to at a point.
struct Strip {
  double from, to, y;
  bool point;
};

struct SliceSection {
  std::size_t shape;  // its number
  std::vector<Strip> strips;
};

struct SliceLayer {
  Frame frame;
  double width;                        // of a strip
  std::vector<SliceSection> sections;  // larger ones first
  std::vector<Strip> region;
};

/// For each layer the names in it, as SVG.
std::vector<std::string> slice_names(const std::vector<SliceLayer>& layers, const std::vector<std::string>& names);

}  // namespace findspace::io
