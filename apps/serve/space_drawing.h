// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How sets in space look, for renderers: the faces of what has volume, sheets, curves and points, each as what it is,
// in the scene's unit. Guarantee: places are the exact ones, rounded once; what is unbounded is left open or cut off at
// the window. Cost: linear in the cells. Keywords: boundary representation, dangling faces.
#pragma once

#include <findspace/scene.h>
#include <findspace/space_region.h>
#include <findspace/surface.h>
#include <findspace/values.h>

#include <string>
#include <vector>

namespace findspace::app {

/// A box of the scene's unit, beyond which drawings are cut off.
struct SpaceWindow {
  SpaceRegion::Bounds3 box{};
  bool any = false;

  void include(const Surface& surface);
  /// With as much on every side as it is large.
  SpaceWindow wider() const;
};

struct SpaceDrawing {
  Surface solid{};
  SpaceRegion::Thin thin{};

  std::string json() const;
};

SpaceDrawing drawing_of(const SpaceRegion& region, const SpaceWindow& window);
/// Of positions on the line of a scene.
SpaceDrawing drawing_of_line(const std::vector<Interval>& intervals, const Scene::Free& line,
                             const SpaceWindow& window);

}  // namespace findspace::app
