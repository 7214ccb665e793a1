// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids at one position as a wireframe: what `check` and `measure` draw in space. Each convex part of a body gives its
// edges, hidden ones dashed, over its outline; the outline of a part with a radius is that of its core, as much wider.
// Lines of the moving body are blue, a pair of nearest or farthest points is joined in red. Guarantee: outlines are the
// true ones of an orthogonal view. Cost: linear in the edges, for each part.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "space/body/body.h"

namespace findspace::io {

struct BodiesPicture {
  std::string title, unit;
  std::vector<std::string> lines;  // below the title
  struct Drawn {
    const space::Body* body = nullptr;
    std::array<double, 3> by{};  // in the scene's unit
    bool moving = false;
  };
  std::vector<Drawn> bodies;
  std::vector<std::array<std::array<double, 3>, 2>> pairs;  // in the scene's unit
  double step = 1;                                          // a grid step in the scene's unit
};

std::string bodies_svg(const BodiesPicture& picture);

}  // namespace findspace::io
