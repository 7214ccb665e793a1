// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "planning/solid/space_stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "formula/language/text.h"
#include "planning/order/relations.h"
#include "space/box/box_operations.h"

namespace findspace::planning {

using exact::Real;
using formula::Atom;
using formula::Formula;
using formula::Node;
using formula::SpaceShape;
using space::RealVector;

namespace {

std::optional<space::Point> on_grid(const RealVector& p) {
  std::array<std::int64_t, 3> c{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto whole = p[k].integer();
    if (!whole || *whole > exact::kRayLimit || *whole < -exact::kRayLimit) return std::nullopt;
    c[k] = static_cast<std::int64_t>(*whole);
  }
  return space::Point{c[0], c[1], c[2]};
}

std::shared_ptr<const std::vector<space::RaySolid>> moved(std::vector<space::RaySolid> solids, const space::Point& by) {
  for (space::RaySolid& s : solids) s = space::moved(std::move(s), by);
  return std::make_shared<const std::vector<space::RaySolid>>(std::move(solids));
}

SpaceShape moved(const SpaceShape& shape, const RealVector& by) {
  if (space::is_zero(by)) return shape;
  SpaceShape out;
  out.refused = shape.refused;
  out.convex = shape.convex;
  if (shape.boxes) out.boxes = space::translated(*shape.boxes, by);
  const auto whole = on_grid(by);
  if (shape.body && whole) {
    const auto make = [body = shape.body, whole]() -> exact::Tried<formula::LazyBody::Pointer> {
      const auto made = body.try_pointer();
      if (!made) return made;
      return std::make_shared<const space::Body>(translated(**made, *whole));
    };
    out.body = shape.body.made() ? formula::LazyBody(make().or_throw()) : formula::LazyBody::later(make);
  }
  if (shape.surfaces && whole) out.surfaces = moved(*shape.surfaces, *whole);
  if (shape.cut && whole) out.cut = std::make_shared<const space::CsgSolid>(translated(*shape.cut, *whole));
  if ((shape.body || shape.cut) && !whole) out.refused = "the shape stands off the grid";
  return out;
}

plane::ShapePtr moved(const plane::ShapePtr& shape, const std::string& name, const RealVector& by) {
  if (space::is_zero(by)) return shape;
  const auto whole = on_grid(by);
  if (!whole)
    throw Error(ErrorCode::kUnsupported,
                fmt::format("'{}' stands off the grid, where this is not computed; \"grid\" as the last entry of "
                            "\"minimize\" keeps positions on it",
                            name));
  plane::Shape out;
  out.kind = plane::Shape::Kind::kTranslate;
  out.name = name;
  out.place = shape->place;
  out.children = {shape};
  out.points = {plane::GridPoint{whole->x, whole->y}};
  out.lift = whole->z;
  return std::make_shared<const plane::Shape>(std::move(out));
}

/// One way of a shape that stands is the other way of the one that moves.
void go_back(formula::Distance& d) {
  if (d.mode != formula::Mode::kToward) return;
  std::vector<std::string> numbers;
  for (Real& c : d.vector) numbers.push_back(formula::number_text(c = -c));
  d.vector_text = fmt::format("({})", fmt::join(numbers, ", "));
}

}  // namespace

SpaceStage::SpaceStage(const SpaceProblem& problem, const SpacePoses& others, std::size_t body, std::size_t angle)
    : problem_(problem), body_(body) {
  std::vector<std::string> placed;
  for (const Body& b : problem.bodies) {
    for (const auto& variant : b.variants) placed.insert(placed.end(), variant.begin(), variant.end());
    placed.insert(placed.end(), b.shapes.begin(), b.shapes.end());
  }
  for (const auto& [name, shape] : problem.shapes)
    if (std::find(placed.begin(), placed.end(), name) == placed.end()) standing_[name] = {name, {}};
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    if (b == body)
      add_shapes(b, SpacePose{angle, {}});
    else if (others[b])
      add_shapes(b, *others[b]);
  }
  moving_ = of_body_.at(body);
  std::vector<Formula> all;
  for (const Condition& c : problem.conditions)
    if (counts(bodies_of(*c.formula, c.roles), others)) all.push_back(bound(c));
  formula_ = formula::conjunction(all);
}

void SpaceStage::add_shapes(std::size_t body, const SpacePose& pose) {
  const Body& b = problem_.bodies[body];
  for (const std::string& shape : b.variants[pose.angle]) {
    std::string name = b.copy > 0 ? fmt::format("{} {}", shape, b.copy) : shape;
    while (!standing_.emplace(name, Standing{shape, pose.at}).second) name += "'";
    of_body_[body].push_back(name);
  }
}

/// Whether a condition on these bodies speaks of this one, or of none, and all others stand.
bool SpaceStage::counts(const std::vector<std::size_t>& bodies, const SpacePoses& others) const {
  const bool speaks = bodies.empty() || std::find(bodies.begin(), bodies.end(), body_) != bodies.end();
  return speaks && std::all_of(bodies.begin(), bodies.end(), [&](std::size_t b) { return b == body_ || others[b]; });
}

SpaceStage::Names SpaceStage::names(const Names& wanted, const Roles& roles) const {
  Names out;
  for (const std::string& name : wanted) {
    const auto role = roles.find(name);
    if (role == roles.end()) {
      out.push_back(name);
      continue;
    }
    const Names& all = of_body_.at(role->second.body);
    if (role->second.shape)
      out.push_back(all[*role->second.shape]);
    else
      out.insert(out.end(), all.begin(), all.end());
  }
  return out;
}

bool SpaceStage::moves(const Names& names) const {
  return std::find(moving_.begin(), moving_.end(), names.at(0)) != moving_.end();
}

Node SpaceStage::bound_node(const Node& node, const Condition& condition, std::vector<Atom>& atoms) const {
  Node out{node.op, 0, {}};
  for (const Node& operand : node.operands) out.operands.push_back(bound_node(operand, condition, atoms));
  if (node.op != Node::Op::kAtom) return out;
  Atom atom = condition.formula->atoms()[node.atom];
  atom.distance.first = names(atom.distance.first, condition.roles);
  atom.distance.second = names(atom.distance.second, condition.roles);
  const bool first = moves(atom.distance.first);
  if (first || moves(atom.distance.second)) {
    const Names& named = condition.formula->atoms()[node.atom].distance.first;
    if (!first && condition.roles.count(named.at(0)) != 0) go_back(atom.distance);
    out.atom = atoms.size();
    atoms.push_back(std::move(atom));
    return out;
  }
  const formula::SpaceSolver solver(world(atom.distance.first));
  const bool holds = solver.check(Formula(atom), RealVector{}).holds;
  return Node{holds ? Node::Op::kTrue : Node::Op::kFalse, 0, {}};
}

Formula SpaceStage::bound(const Condition& condition) const {
  std::vector<Atom> atoms;
  Node root = bound_node(condition.formula->root(), condition, atoms);
  return Formula(std::move(root), std::move(atoms));
}

formula::SpaceWorld SpaceStage::world(const Names& moving) const {
  formula::SpaceWorld out;
  for (const auto& [name, standing] : standing_)
    out.shapes.emplace(name, moved(problem_.built.at(standing.shape), standing.at));
  out.moving = moving;
  out.step = problem_.step;
  return out;
}

formula::RayWorld SpaceStage::rays() const {
  formula::RayWorld out;
  for (const auto& [name, standing] : standing_) {
    plane::ShapePtr shape = moved(problem_.shapes.at(standing.shape), name, standing.at);
    out.shapes.emplace(name, formula::RayShape(shape));
  }
  out.moving = moving_;
  out.step = problem_.step;
  return out;
}

}  // namespace findspace::planning
