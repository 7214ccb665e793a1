// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids at one position: what `check` and `measure` draw in space. Each convex part of a body gives its faces, shaded,
// and of its edges the creases and the silhouette (draw_surface.h); hidden creases are dashed. A part with a radius is
// the outline of its core, as much wider. The moving body is blue. A pair of points that take a distance is joined
// and has its value, red where a condition fails; an arrow is a way to a touching. Each solid has its name, and axes
// with ticks stand about all. Guarantee: outlines are the true ones of an orthogonal view; faces that pass through each
// other are laid by the depth of their middles. Cost: n log n in the edges. Keywords: painter's algorithm.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "space/body/body.h"
#include "space/box/box_summary.h"
#include "space/convolution/ray_solids.h"

namespace findspace::io {

struct DrawnSurface {
  std::vector<space::Place3> vertices;  // in the scene's unit
  std::vector<std::vector<int>> faces;
};

struct BodiesPicture {
  std::string title, unit;
  std::vector<std::string> lines;  // below the title
  enum class Role { kFixed, kMoving, kRegion };
  /// A body, or surfaces in grid steps, or one in the scene's unit.
  struct Drawn {
    std::string name;
    const space::Body* body = nullptr;
    const std::vector<space::RaySolid>* solids = nullptr;
    const DrawnSurface* surface = nullptr;
    space::Place3 by{};  // in the scene's unit
    Role role = Role::kFixed;
  };
  std::vector<Drawn> bodies;
  struct Pair {
    std::array<space::Place3, 2> ends{};  // in the scene's unit
    std::string text{};
    bool fails = false;
    bool arrow = false;  // from the first to the second
  };
  std::vector<Pair> pairs;
  double step = 1;  // a grid step in the scene's unit
};

/// Of the box about what is drawn, in the scene's unit.
space::Place3 middle_of(const BodiesPicture::Drawn& drawn, double step);

std::string bodies_svg(const BodiesPicture& picture);

}  // namespace findspace::io
