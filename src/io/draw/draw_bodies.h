// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids at one position: what `check` and `measure` draw in space. Each convex part of a body gives its faces, shaded,
// and of its edges the creases and the silhouette (draw_surface.h); hidden creases are dashed. A part with a radius is
// the outline of its core, as much wider. The moving body is blue, a pair of nearest or farthest points is joined in
// red. Guarantee: outlines are the true ones of an orthogonal view; faces that pass through each other are laid by the
// depth of their middles. Cost: n log n in the edges. Keywords: painter's algorithm.
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
