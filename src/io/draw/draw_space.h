// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A picture of a 3D map of boxes: the solid parts of the region as shaded faces, its sheets in a second colour, lines
// and points of the region drawn heavy, the fixed shapes as grey creases, and the moving shape as blue ones at a sample
// position. Each shape has its name, and axes with ticks stand about all. The view is that of draw_view.h; faces are
// laid from back to front. Cost: linear in the cells.
// Keywords: SVG, painter's algorithm.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "space/box/box_complex.h"
#include "space/box/box_summary.h"

namespace findspace::io {

struct SpacePicture {
  std::string title, subtitle, unit;
  const space::BoxComplex* region = nullptr;
  struct Named {
    std::string name;
    space::BoxComplex set;
  };
  std::vector<Named> fixed, moving;  // moving: already at the sample position
  exact::Real step;
};

/// Unbounded parts of the region are not drawn.
std::string space_svg(const SpacePicture& picture);

}  // namespace findspace::io
