// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/placement_problem.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "io/question/placement_demands.h"
#include "plane/contour/shape.h"

namespace findspace::io {
namespace {

using planning::Body;
using planning::Problem;

plane::ShapePtr rotated(const plane::ShapePtr& shape, const exact::Real& degrees, const std::string& name) {
  plane::Shape rotation;
  rotation.kind = plane::Shape::Kind::kRotate;
  rotation.name = name;
  rotation.place = shape->place;
  rotation.points = {plane::GridPoint{0, 0}};
  rotation.degrees = degrees;
  rotation.children = {shape};
  return std::make_shared<const plane::Shape>(std::move(rotation));
}

/// All shapes of the scene, or of a board, which has many, those that are placed or that conditions and goals name.
std::vector<plane::ShapePtr> wanted_shapes(const AskedScene& asked, const Problem& problem) {
  const std::vector<plane::ShapePtr>& all = asked.scene().shapes;
  if (!asked.scene().named_only) return all;
  std::set<std::string> names;
  const auto add = [&](const formula::Distance& d) {
    names.insert(d.first.begin(), d.first.end());
    names.insert(d.second.begin(), d.second.end());
  };
  for (const auto& body : problem.bodies) names.insert(body.shapes.begin(), body.shapes.end());
  for (const auto& condition : problem.conditions)
    for (const formula::Atom& a : condition.formula->atoms()) add(a.distance);
  for (const formula::Goal& goal : problem.goals)
    if (goal.objective)
      for (const formula::Distance& d : formula::distances_of(*goal.objective)) add(d);
  std::vector<plane::ShapePtr> out;
  std::copy_if(all.begin(), all.end(), std::back_inserter(out),
               [&](const plane::ShapePtr& s) { return names.count(s->name) > 0; });
  return out;
}

}  // namespace

Problem placement_problem(const AskedScene& asked) {
  planning::AskedDemands wanted = placement_demands(asked);
  Problem problem{std::move(wanted.demands), {}};
  asked.stage("building the shapes");
  std::vector<plane::ShapePtr> shapes = wanted_shapes(asked, problem);
  for (const planning::RotatedShape& t : wanted.rotated)
    shapes.push_back(rotated(asked.scene().shape(t.shape), t.turn.degrees, t.name));
  std::vector<plane::Region> built = asked.regions(shapes);
  for (std::size_t k = 0; k < built.size(); ++k) problem.world.shapes.emplace(shapes[k]->name, std::move(built[k]));
  std::set<std::string> moving;
  for (const Body& body : problem.bodies)
    for (const auto& names : body.variants) moving.insert(names.begin(), names.end());
  problem.world.moving.assign(moving.begin(), moving.end());
  problem.world.step = asked.step();
  return problem;
}

}  // namespace findspace::io
