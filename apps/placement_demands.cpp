// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "placement_demands.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "formula/language/text.h"
#include "planning/order/relations.h"

namespace findspace::app {
namespace {

using planning::Body;
using planning::Roles;

class Maker {
 public:
  explicit Maker(const Session& session) : session_(session), place_(session.scene().place) {}

  PlacementDemands run() {
    add_bodies();
    add_each();
    add_pairs();
    add_constraints();
    add_objectives();
    return std::move(out_);
  }

 private:
  void add_bodies() {
    for (const plane::ShapePtr& s : session_.scene().shapes) taken_.insert(s->name);
    for (const io::PlacedBody& placed : place_.bodies) {
      Body body{placed.name, 0, placed.shapes, placed.angles, {}};
      for (const exact::Real& angle : placed.angles) body.variants.push_back(variant(placed, angle));
      for (int copy = 1; copy <= placed.count; ++copy) {
        body.copy = placed.count > 1 ? copy : 0;
        demands_.bodies.push_back(body);
      }
      if (placed.count == 1) add_names(demands_.bodies.size() - 1);
    }
  }

  std::vector<std::string> variant(const io::PlacedBody& body, const exact::Real& angle) {
    std::vector<std::string> names;
    for (const std::string& shape : body.shapes) {
      names.push_back(shape);
      if (angle.sign() == 0) continue;
      std::string name = fmt::format("{} rotated by {}", shape, formula::decimal_text(angle));
      while (!taken_.insert(name).second) name += "'";
      out_.rotated.push_back({name, shape, angle});
      names.back() = name;
    }
    return names;
  }

  void add_names(std::size_t index) {
    const Body& body = demands_.bodies[index];
    demands_.names[body.name] = {index, std::nullopt};
    for (std::size_t k = 0; body.shapes.size() > 1 && k < body.shapes.size(); ++k)
      demands_.names[body.shapes[k]] = {index, k};
  }

  /// What stands still: the scene without the placed shapes.
  formula::Context fixed_context() const {
    formula::Context context = session_.context();
    context.moving = {"self"};
    context.shapes.clear();
    for (const plane::ShapePtr& s : session_.scene().shapes) {
      const bool placed = std::any_of(place_.bodies.begin(), place_.bodies.end(), [&](const io::PlacedBody& b) {
        return std::find(b.shapes.begin(), b.shapes.end(), s->name) != b.shapes.end();
      });
      (placed ? context.placed : context.shapes).push_back(s->name);
    }
    return context;
  }

  formula::Context named_context() const {
    formula::Context context = fixed_context();
    context.moving.clear();
    context.placed.clear();
    context.independent = true;
    for (const auto& [name, role] : demands_.names) context.moving.push_back(name);
    return context;
  }

  using FormulaPointer = std::shared_ptr<const formula::Formula>;
  FormulaPointer parsed(const io::FormulaText& text, const formula::Context& context) const {
    return std::make_shared<const formula::Formula>(session_.formula(text, context));
  }

  void add_each() {
    if (place_.each.empty()) return;
    const FormulaPointer formula = parsed(place_.each, fixed_context());
    for (std::size_t i = 0; i < demands_.bodies.size(); ++i)
      demands_.conditions.push_back({formula, {{"self", {i, {}}}}});
  }

  void add_pairs() {
    if (place_.pairs.empty()) return;
    formula::Context context = fixed_context();
    context.extra = {"other"};
    const FormulaPointer formula = parsed(place_.pairs, context);
    for (std::size_t i = 0; i < demands_.bodies.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        demands_.conditions.push_back({formula, {{"self", {i, {}}}, {"other", {j, {}}}}});
  }

  void add_constraints() {
    for (const io::FormulaText& text : place_.constraints) {
      const FormulaPointer formula = parsed(text, named_context());
      Roles roles;
      for (const formula::Atom& atom : formula->atoms()) check_and_note(atom, text, roles);
      demands_.conditions.push_back({formula, std::move(roles)});
    }
  }

  void check_and_note(const formula::Atom& atom, const io::FormulaText& text, Roles& roles) const {
    std::set<std::size_t> first, second;
    for (const auto& [names, bodies] :
         {std::pair(&atom.distance.first, &first), std::pair(&atom.distance.second, &second)})
      for (const std::string& name : *names)
        if (auto found = demands_.names.find(name); found != demands_.names.end()) {
          roles.insert(*found);
          bodies->insert(found->second.body);
        }
    if (!first.empty() && first == second) {
      throw Error(ErrorCode::kBadValue,
                  fmt::format("{}: the two move together, so their distance never changes", formula::written(atom)),
                  fmt::format("{}:{}:{}", text.file, text.line, text.column));
    }
  }

  void add_objectives() {
    formula::Context context = named_context();
    context.moving.push_back("self");
    for (const io::FormulaText& text : place_.minimize) demands_.goals.push_back(session_.goal(text, context));
  }

  const Session& session_;
  const io::Placement& place_;
  PlacementDemands out_;
  planning::Demands& demands_ = out_.demands;
  std::set<std::string> taken_;
};

}  // namespace

PlacementDemands placement_demands(const Session& session) {
  const io::Scene& scene = session.scene();
  auto refuse = [&](const std::string& what) { throw Error(ErrorCode::kUnsupported, what, scene.file); };
  if (!scene.place.given())
    throw Error(ErrorCode::kBadValue, "the scene has no \"place\": nothing says what to place", scene.file);
  if (scene.motion.given()) refuse("a placement over a \"motion\" is not computed");
  if (scene.free.kind != io::Free::Kind::kPosition)
    refuse("a placement ranges over positions: \"free\" has no meaning with it");
  return Maker(session).run();
}

}  // namespace findspace::app
