// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How sets in space look, for renderers: the faces of what has volume, sheets, curves and points, each as what it is,
// in the scene's unit. Guarantee: places are the exact ones, rounded once; what is unbounded is left open or cut off at
// the window. Cost: linear in the cells. Keywords: boundary representation, dangling faces.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/mesh/write_mesh.h"
#include "plane/query/locate_line.h"
#include "space/box/box_complex.h"
#include "space/box/convex_set.h"

namespace findspace::app {

using SpacePlace = std::array<double, 3>;

/// A box of the scene's unit, beyond which drawings are cut off.
struct SpaceWindow {
  SpacePlace low{}, high{};
  bool any = false;

  void include(const io::Surface& surface);
  /// With as much on every side as it is large.
  SpaceWindow wider() const;
};

struct SpaceDrawing {
  io::Surface solid;
  std::vector<std::vector<SpacePlace>> sheets, curves;
  std::vector<SpacePlace> points;

  std::string json() const;
};

/// `step`: a grid step in the scene's unit.
SpaceDrawing drawing_of_boxes(const space::BoxComplex& set, const exact::Real& step, const SpaceWindow& window);
SpaceDrawing drawing_of_convex(const space::ConvexSet& set, const exact::Real& step);
/// Of positions on a line through a point of the scene.
SpaceDrawing drawing_of_line(const std::vector<plane::LineInterval>& intervals, const SpacePlace& through,
                             const SpacePlace& direction, const SpaceWindow& window);

}  // namespace findspace::app
