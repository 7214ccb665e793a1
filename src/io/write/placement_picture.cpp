// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pictures of placements: what stands still, and every placed body where it was put.

#include <algorithm>

#include "io/draw/draw_bodies.h"
#include "io/write/write_placement.h"
#include "io/write/write_svg.h"
#include "plane/query/moved.h"

namespace findspace::io {

using planning::Body;

std::vector<std::string> standing_still(const planning::Demands& demands, const std::vector<std::string>& names) {
  std::vector<std::string> out;
  std::copy_if(names.begin(), names.end(), std::back_inserter(out), [&](const std::string& name) {
    return demands.names.count(name) == 0 &&
           std::none_of(demands.bodies.begin(), demands.bodies.end(), [&](const Body& b) {
             return std::find(b.shapes.begin(), b.shapes.end(), name) != b.shapes.end();
           });
  });
  return out;
}

std::vector<NamedRegion> PlacedRegions::named() const {
  std::vector<NamedRegion> all;
  for (std::size_t k = 0; k < regions.size(); ++k) all.push_back({names[k], &regions[k]});
  return all;
}

PlacedRegions placed_regions(const planning::Problem& problem, const planning::Poses& poses) {
  PlacedRegions out;
  for (std::size_t b = 0; b < poses.size(); ++b) {
    if (!poses[b]) continue;
    const Body& body = problem.bodies[b];
    for (std::size_t k = 0; k < body.shapes.size(); ++k) {
      const std::string& variant = body.variants[poses[b]->angle][k];
      out.regions.push_back(plane::moved(problem.world.shapes.at(variant), poses[b]->at));
      out.names.push_back(body.shapes[k]);
    }
  }
  return out;
}

std::string placement_svg(const planning::Problem& problem, const planning::Poses& poses,
                          const PlacementPicture& picture) {
  Picture p;
  p.title = picture.title;
  p.subtitle = picture.subtitle;
  p.step = problem.world.step;
  p.unit = picture.unit;
  p.of_positions = false;
  p.y_down = picture.y_down;
  p.small_names = picture.is_board;
  p.copper = picture.copper;
  for (const std::string& name : picture.fixed)
    if (problem.world.shapes.count(name) > 0)
      p.fixed.push_back({picture.is_board && name == "board" ? "" : name, &*problem.world.shapes.at(name)});
  p.fixed.insert(p.fixed.end(), picture.parts.begin(), picture.parts.end());
  const PlacedRegions placed = placed_regions(problem, poses);
  p.placed = placed.named();
  return picture_svg(p);
}

std::string placement_svg(const planning::SpaceProblem& problem, const planning::SpacePoses& poses,
                          const PlacementPicture& picture) {
  BodiesPicture out{picture.title, picture.unit, picture.lines, {}, {}, problem.step.to_double()};
  for (const std::string& name : picture.fixed)
    if (const auto& body = problem.built.at(name).body) out.bodies.push_back({name, body.get()});
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto& pose = poses[b];
    if (!pose) continue;
    const Body& placed = problem.bodies[b];
    for (std::size_t k = 0; k < placed.shapes.size(); ++k) {
      const auto& body = problem.built.at(placed.variants[pose->angle][k]).body;
      if (!body) continue;
      auto& drawn = out.bodies.emplace_back(BodiesPicture::Drawn{placed.shapes[k], body.get()});
      drawn.role = BodiesPicture::Role::kMoving;
      for (std::size_t axis = 0; axis < 3; ++axis) drawn.by[axis] = (pose->at[axis] * problem.step).to_double();
    }
  }
  return bodies_svg(out);
}

}  // namespace findspace::io
