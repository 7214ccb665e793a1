// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/scene/scene_regions.h"

#include <fmt/format.h>

#include "findspace/error.h"
#include "plane/base/parallel.h"
#include "plane/build/build.h"

namespace findspace::io {

std::vector<plane::Region> regions_of(const Scene& scene, const std::vector<plane::ShapePtr>& shapes,
                                      std::vector<std::string>& notes) {
  if (scene.dimension != 2) throw Error(ErrorCode::kUnsupported, "the scene has 3D shapes", scene.file);
  std::vector<plane::BuildResult> built(shapes.size());
  plane::parallel_for(shapes.size(), [&](std::size_t k) {
    built[k] = plane::build(*shapes[k], scene.grid.step_size(), scene.work_limit);
  });
  std::vector<plane::Region> out;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const plane::Rounding& moved = built[k].rounding;
    if (moved.points > 0)
      notes.push_back(
          rotated_note(scene, shapes[k]->name, std::size_t(moved.points), moved.largest * scene.grid.step_size()));
    out.push_back(std::move(built[k].region));
  }
  return out;
}

std::string rotated_note(const Scene& scene, const std::string& name, std::size_t points, double largest) {
  return fmt::format("shape '{}': {} rotated points were put on the grid, moved by at most {:.2g}{}{}", name, points,
                     largest, scene.unit ? " " : "", scene.unit ? formula::name(*scene.unit) : "");
}

}  // namespace findspace::io
