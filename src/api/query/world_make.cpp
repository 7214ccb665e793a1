// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a public world is made of: names, the grid of all shapes, their motion, the solver.

#include <fmt/format.h>

#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "formula/language/lexer.h"
#include "formula/language/text.h"
#include "formula/solid/faults.h"
#include "formula/solid/solve_rays.h"
#include "plane/build/build.h"

namespace findspace {

using exact::Real;

namespace {

std::optional<formula::Unit> unit_of(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (const auto unit = formula::find_unit(name)) return unit;
  throw Error(ErrorCode::kUnknownName,
              fmt::format("unknown unit '{}'; the units are {}", name, fmt::join(formula::kUnitNames, ", ")));
}

formula::Trajectory trajectory_of(const World::Data& world, const std::vector<WayPoint>& path,
                                  const formula::Motion& motion) {
  if (path.empty()) throw Error(ErrorCode::kBadValue, "a path needs at least one way point");
  formula::Trajectory out;
  plane::RoundingLog rounding;
  for (const WayPoint& w : path) {
    const Real time = api::real_of(w.time);
    if (time < motion.start || motion.end < time)
      throw Error(ErrorCode::kBadValue, "a way point's time is outside the time of the motion");
    if (!out.times.empty() && !(out.times.back() < time)) throw Error(ErrorCode::kBadValue, "times must ascend");
    const plane::GridPoint at = world.grid.nearest(api::real_of(w.at.x), api::real_of(w.at.y), rounding);
    out.times.push_back(time);
    out.path.push_back({Real(at.x), Real(at.y)});
    out.angles.push_back(api::real_of(w.degrees));
  }
  return out;
}

/// The parts of a collection by their names, or numbers where they have none.
formula::Parts::mapped_type parts_of(const Shape& shape, const plane::Grid& grid) {
  formula::Parts::mapped_type out;
  const plane::ShapePtr tree = api::tree_on(shape, grid);
  for (std::size_t k = 0; k < tree->children.size(); ++k) {
    const std::string& name = tree->children[k]->name;
    out.emplace_back(name.empty() ? std::to_string(k) : name,
                     plane::build(*tree->children[k], grid.step_size()).region);
  }
  return out;
}

std::shared_ptr<const formula::Solver> planar_solver(const World::Data& data) {
  formula::World world;
  for (const auto& [name, shape] : data.shapes) {
    world.shapes.emplace(name, api::region_on(shape, data.grid, name));
    if (api::tree_of(shape)->collection) world.parts[name] = parts_of(shape, data.grid);
  }
  world.moving = data.context.moving;
  world.step = data.grid.step();
  if (data.motion) world.motion = api::motion_of(data, *data.motion);
  if (data.time) world.instant = api::real_of(*data.time);
  return std::make_shared<const formula::Solver>(std::move(world));
}

/// Shapes of `before` whose trees are the same are taken over.
std::shared_ptr<const formula::SpaceSolver> solid_solver(const World::Data& data, const World::Data* before) {
  formula::SpaceWorld world;
  auto rays = std::make_shared<formula::RayWorld>();
  rays->moving = world.moving = data.context.moving;
  rays->step = world.step = data.grid.step();
  for (const auto& [name, shape] : data.shapes) {
    const plane::ShapePtr tree = api::tree_on(shape, data.grid);
    const auto known = before ? before->shapes.find(name) : data.shapes.end();
    const bool same = before && known != before->shapes.end() && &known->second.data() == &shape.data() &&
                      before->grid.step() == data.grid.step();
    rays->shapes.emplace(name, same ? before->solid->world().rays->shapes.at(name) : formula::RayShape(tree));
    world.shapes.emplace(name, same ? before->solid->world().shapes.at(name) : api::solid_on(*tree));
  }
  world.rays = std::move(rays);
  return std::make_shared<const formula::SpaceSolver>(std::move(world));
}

}  // namespace

namespace api {

void unknown_shape(const formula::Context& context, const std::string& name) {
  const std::string near = formula::question(name, context.shapes);
  throw Error(ErrorCode::kUnknownName,
              fmt::format("there is no shape '{}'{}", name,
                          near.empty() ? "; the shapes are " + formula::listed(context.shapes) : near));
}

formula::Context context_of(const std::map<std::string, Shape>& shapes, const std::string& unit) {
  formula::Context context;
  for (const auto& [name, shape] : shapes) context.shapes.push_back(name);
  context.unit = unit_of(unit);
  context.dimension = shapes.begin()->second.dimension();
  for (const auto& [name, shape] : shapes)
    if (shape.dimension() != context.dimension)
      throw Error(ErrorCode::kBadValue, "shapes of the plane and of space in one world",
                  fmt::format("shape '{}'", name));
  return context;
}

plane::Grid grid_of(const std::map<std::string, Shape>& shapes) {
  plane::Grid grid = shapes.begin()->second.data().grid;
  for (const auto& [name, shape] : shapes) grid = common_grid(grid, shape.data().grid);
  return grid;
}

plane::Region region_on(const Shape& shape, const plane::Grid& grid, const std::string& name) {
  try {
    if (shape.data().grid.step() == grid.step()) return shape.region().data().cells;
    return plane::build(*tree_on(shape, grid), grid.step_size()).region;
  } catch (const Error& e) {
    throw e.within(fmt::format("shape '{}'", name));
  }
}

formula::SpaceShape solid_on(const plane::Shape& tree) {
  auto made = formula::throwing_faults(formula::try_space_shape(tree));
  if (made) return *std::move(made);
  formula::SpaceShape none;
  none.refused = made.refusal().error.what();  // its surface may do
  return none;
}

formula::Motion motion_of(const World::Data& world, const Motion& motion) {
  formula::Motion out{real_of(motion.start), real_of(motion.end), {}};
  if (!(out.start < out.end)) throw Error(ErrorCode::kBadValue, "a motion ends after it starts");
  if (motion.paths.empty()) throw Error(ErrorCode::kBadValue, "the motion moves no shape");
  for (const auto& [name, path] : motion.paths) {
    try {
      world.shape(name);
      out.of.emplace(name, trajectory_of(world, path, out));
    } catch (const Error& e) {
      throw e.within(fmt::format("the path of '{}'", name));
    }
  }
  return out;
}

void make_solver(World::Data& data, const World::Data* before) {
  if (data.dimension() == 2)
    data.planar = planar_solver(data);
  else
    data.solid = solid_solver(data, before);
}

}  // namespace api
}  // namespace findspace
