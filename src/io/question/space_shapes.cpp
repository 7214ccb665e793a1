// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/space_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "formula/solid/faults.h"
#include "formula/solid/solve_rays.h"
#include "io/question/ray_map.h"
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

bool drawn_by_members(const AskedScene& asked, const std::string& name) {
  const auto& shapes = asked.scene().shapes;
  const auto known = [&](const plane::ShapePtr& member) {
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](const plane::ShapePtr& s) { return !member->name.empty() && s->name == member->name; });
  };
  const plane::ShapePtr shape = asked.scene().shape(name);
  return shape->collection && !shape->children.empty() &&
         std::all_of(shape->children.begin(), shape->children.end(), known);
}

namespace {

/// What holds a solid that round ones are cut out of: drawn where the lines of a picture pass beside the solid.
std::shared_ptr<const space::Body> uncut_body(const space::CsgSolid& cut) {
  space::Body out;
  out.scale = cut.scale;
  for (const space::CsgPart& part : cut.parts)
    out.parts.insert(out.parts.end(), part.within.begin(), part.within.end());
  return std::make_shared<const space::Body>(std::move(out));
}

/// The surface of a solid that round ones are cut out of, as lines give it: in the scene's unit, moved.
std::shared_ptr<const DrawnSurface> cut_surface(const plane::Shape& shape, double step, const space::Place3& by) {
  constexpr int kLines = 48;
  const Surface found = surface_on_lines(shape, kLines, step);
  auto out = std::make_shared<DrawnSurface>();
  for (const auto& v : found.vertices) out->vertices.push_back({v[0] + by[0], v[1] + by[1], v[2] + by[2]});
  for (const auto& f : found.faces) out->faces.emplace_back(f.begin(), f.end());
  return out;
}

}  // namespace

KeptBodies add_bodies(BodiesPicture& picture, const AskedScene& asked, const formula::SpaceWorld& world,
                      const std::optional<space::Place3>& moving_at) {
  KeptBodies kept;
  for (const bool moving : {false, true}) {
    if (moving && !moving_at) continue;
    for (const auto& [name, shape] : world.shapes) {
      const bool moves = std::find(world.moving.begin(), world.moving.end(), name) != world.moving.end();
      if (moves != moving || (!shape.body && !shape.cut) || drawn_by_members(asked, name)) continue;
      BodiesPicture::Drawn drawn{name};
      std::shared_ptr<const DrawnSurface> surface;
      if (shape.cut && !shape.surfaces)
        surface = cut_surface(*asked.scene().shape(name), asked.scene().grid.step_size(),
                              moving ? *moving_at : space::Place3{});
      if (shape.surfaces) {
        drawn.solids = shape.surfaces.get();  // its convex parts may be many
      } else if (surface && !surface->faces.empty()) {
        drawn.surface = surface.get();
        kept.push_back(surface);
      } else {
        const std::shared_ptr<const space::Body> body = shape.cut ? uncut_body(*shape.cut) : shape.body.pointer();
        drawn.body = body.get();
        kept.push_back(body);
      }
      if (moving) {
        drawn.role = BodiesPicture::Role::kMoving;
        drawn.by = *moving_at;
      }
      picture.bodies.push_back(std::move(drawn));
    }
  }
  return kept;
}

void note_rounding(const AskedScene& asked, const std::string& name, const formula::SpaceShape& shape) {
  const auto note = [&](const auto& made) {
    if (made.rounded == 0) return;
    asked.note(fmt::format(
        "shape '{}': {} vertices of its convex parts were put on the grid, moved by at most {:.2g}{}{}", name,
        made.rounded, made.moved * asked.scene().grid.step_size(), asked.unit().empty() ? "" : " ", asked.unit()));
  };
  if (shape.body.made()) note(*shape.body);
  if (shape.cut) note(*shape.cut);
}

}  // namespace findspace::io
