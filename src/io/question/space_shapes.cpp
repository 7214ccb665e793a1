// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/space_shapes.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "formula/solid/faults.h"
#include "formula/solid/solve_rays.h"
#include "plane/base/parallel.h"

namespace findspace::io {

std::map<std::string, formula::SpaceShape> space_shapes(const AskedScene& asked,
                                                        const std::vector<plane::ShapePtr>& shapes) {
  asked.stage("building the shapes");
  std::vector<formula::SpaceShape> built(shapes.size());
  plane::parallel_for(built.size(), [&](std::size_t k) {
    auto made = formula::throwing_faults(formula::try_space_shape(*shapes[k]));
    if (made)
      built[k] = *std::move(made);
    else
      built[k].refused = made.refusal().error.what();  // its surface may do
  });
  std::map<std::string, formula::SpaceShape> out;
  for (std::size_t k = 0; k < built.size(); ++k) {
    note_rounding(asked, shapes[k]->name, built[k]);
    out.emplace(shapes[k]->name, std::move(built[k]));
  }
  return out;
}

formula::SpaceWorld space_world(const AskedScene& asked) {
  formula::SpaceWorld world;
  world.shapes = space_shapes(asked, asked.scene().shapes);
  world.moving = asked.scene().moving;
  world.step = asked.step();
  world.rays = std::make_shared<const formula::RayWorld>(ray_world(asked));
  return world;
}

std::shared_ptr<const formula::SpaceSolver> space_solver(const AskedScene& asked) {
  const auto make = [&] { return std::make_shared<const formula::SpaceSolver>(space_world(asked)); };
  return asked.kept() != nullptr ? asked.kept()->shapes->solid.get(make) : make();
}

formula::RayWorld ray_world(const AskedScene& asked) {
  formula::RayWorld world;
  for (const auto& shape : asked.scene().shapes) world.shapes.emplace(shape->name, formula::RayShape(shape));
  world.moving = asked.scene().moving;
  world.step = asked.step();
  return world;
}

void note_rounding(const AskedScene& asked, const std::string& name, const formula::SpaceShape& shape) {
  const auto note = [&](const auto& made) {
    if (made.rounded == 0) return;
    asked.note(
        fmt::format("shape '{}': {} vertices of its convex parts were put on the grid, moved by at most {:.2g} {}",
                    name, made.rounded, made.moved * asked.scene().grid.step_size(), asked.unit()));
  };
  if (shape.body.made()) note(*shape.body);
  if (shape.cut) note(*shape.cut);
}

}  // namespace findspace::io
