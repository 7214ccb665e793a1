// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/order/demands.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "findspace/error.h"
#include "formula/language/text.h"

namespace findspace::planning {
namespace {

constexpr const char* kSelf = "self";

class DemandMaker {
 public:
  DemandMaker(const Asked& asked, const formula::Context& all) : asked_(asked), all_(all) {}

  AskedDemands run() {
    add_bodies();
    add_each();
    add_pairs();
    add_constraints();
    add_objectives();
    return std::move(out_);
  }

 private:
  void add_bodies() {
    taken_.insert(all_.shapes.begin(), all_.shapes.end());
    for (const AskedBody& placed : asked_.bodies) {
      Body body{placed.name, 0, placed.shapes, placed.angles, {}};
      for (const Orientation& angle : placed.angles) body.variants.push_back(variant(placed, angle));
      for (int copy = 1; copy <= placed.count; ++copy) {
        body.copy = placed.count > 1 ? copy : 0;
        demands_.bodies.push_back(body);
      }
      if (placed.count == 1) add_names(demands_.bodies.size() - 1);
    }
  }

  std::vector<std::string> variant(const AskedBody& body, const Orientation& angle) {
    std::vector<std::string> names;
    for (const std::string& shape : body.shapes) {
      names.push_back(shape);
      if (angle.none()) continue;
      std::string name =
          fmt::format("{} rotated by {}", shape, angle.rotation ? angle.text : formula::decimal_text(angle.degrees));
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

  /// What stands still: all without the placed shapes.
  formula::Context fixed_context() const {
    formula::Context context = all_;
    context.moving = {kSelf};
    context.shapes.clear();
    for (const std::string& name : all_.shapes) {
      const bool placed = std::any_of(asked_.bodies.begin(), asked_.bodies.end(), [&](const AskedBody& b) {
        return std::find(b.shapes.begin(), b.shapes.end(), name) != b.shapes.end();
      });
      (placed ? context.placed : context.shapes).push_back(name);
    }
    return context;
  }

  formula::Context named_context() const {
    formula::Context context = fixed_context();
    context.moving.clear();
    context.placed.clear();
    context.independent = true;
    for (const auto& [name, role] : demands_.names) {
      context.moving.push_back(name);
      context.body_of.emplace(name, role.body);
    }
    return context;
  }

  using FormulaPointer = std::shared_ptr<const formula::Formula>;
  static FormulaPointer read(const Unread<formula::Formula>& text, const formula::Context& context) {
    const formula::Formula formula = text.read(context);
    std::vector<formula::Atom> atoms = formula.atoms();
    for (formula::Atom& atom : atoms) put_mover_first(atom.distance, context);
    return std::make_shared<const formula::Formula>(formula.root(), std::move(atoms));
  }

  /// One way of a direction is that of `self`, or else that of the placed shape that is named first.
  static void put_mover_first(formula::Distance& d, const formula::Context& context) {
    if (d.mode != formula::Mode::kToward) return;
    const std::string self = kSelf;
    d = moving_first(moving_first(d, {&self, 1}), context.moving);
  }

  void add_each() {
    if (!asked_.each) return;
    const FormulaPointer formula = read(asked_.each, fixed_context());
    for (std::size_t i = 0; i < demands_.bodies.size(); ++i)
      demands_.conditions.push_back({formula, {{kSelf, {i, {}}}}});
  }

  void add_pairs() {
    if (!asked_.pairs) return;
    formula::Context context = fixed_context();
    context.extra = {"other"};
    const FormulaPointer formula = read(asked_.pairs, context);
    for (std::size_t i = 0; i < demands_.bodies.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        demands_.conditions.push_back({formula, {{kSelf, {i, {}}}, {"other", {j, {}}}}});
  }

  /// What a constraint joins by `and` are conditions of their own, so that each counts as soon as its bodies stand. One
  /// that says `self` is one of every body but those that it names.
  void add_constraints() {
    const bool free = demands_.names.count(kSelf) == 0;
    formula::Context context = named_context();
    if (free) context.moving.push_back(kSelf);
    for (const Unread<formula::Formula>& text : asked_.constraints) {
      const FormulaPointer formula = read(text, context);
      const formula::Node& root = formula->root();
      if (root.op != formula::Node::Op::kAnd) {
        add_constraint(formula, text.place, free);
        continue;
      }
      for (const formula::Node& node : root.operands)
        add_constraint(std::make_shared<const formula::Formula>(part_of(*formula, node)), text.place, free);
    }
  }

  void add_constraint(const FormulaPointer& formula, const std::string& place, bool free) {
    if (!free || formula->shapes().count(kSelf) == 0) {
      if (const auto roles = roles_of(*formula, demands_.names))
        return demands_.conditions.push_back({formula, *roles});
      throw Error(ErrorCode::kBadValue,
                  fmt::format("{}: the two move together, so their distance never changes", together_), place);
    }
    for (std::size_t i = 0; i < demands_.bodies.size(); ++i) {
      Roles names = demands_.names;
      names[kSelf] = {i, std::nullopt};
      if (auto roles = roles_of(*formula, names)) demands_.conditions.push_back({formula, *std::move(roles)});
    }
  }

  /// The names that the formula says; nothing where a distance is one of a body to itself.
  std::optional<Roles> roles_of(const formula::Formula& formula, const Roles& names) {
    Roles roles;
    const auto bodies = [&](const std::vector<std::string>& shapes) {
      std::set<std::size_t> out;
      for (const std::string& shape : shapes)
        if (auto found = names.find(shape); found != names.end()) {
          roles.insert(*found);
          out.insert(found->second.body);
        }
      return out;
    };
    for (const formula::Atom& atom : formula.atoms()) {
      const auto first = bodies(atom.distance.first), second = bodies(atom.distance.second);
      if (!first.empty() && first == second) {
        together_ = formula::written(atom);
        return std::nullopt;
      }
    }
    return roles;
  }

  void add_objectives() {
    formula::Context context = named_context();
    context.moving.push_back(kSelf);
    for (const Unread<formula::Goal>& text : asked_.minimize) {
      formula::Goal goal = text.read(context);
      if (goal.objective) put_mover_first(goal.objective->distance, context);
      demands_.goals.push_back(std::move(goal));
    }
  }

  const Asked& asked_;
  const formula::Context& all_;
  AskedDemands out_;
  Demands& demands_ = out_.demands;
  std::set<std::string> taken_;
  std::string together_;  // the atom of which roles_of() gave nothing
};

}  // namespace

void put_first(Demands& demands, const std::vector<Wanted>& wanted) {
  std::vector<std::size_t> order;
  for (const Wanted& w : wanted) order.push_back(w.body);
  for (std::size_t b = 0; b < demands.bodies.size(); ++b)
    if (std::find(order.begin(), order.end(), b) == order.end()) order.push_back(b);
  std::vector<Body> bodies;
  std::vector<std::size_t> becomes(order.size());
  for (const std::size_t b : order) {
    becomes[b] = bodies.size();
    bodies.push_back(std::move(demands.bodies[b]));
  }
  demands.bodies = std::move(bodies);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    Body& body = demands.bodies[k];
    body.near = wanted[k].at;
    if (!wanted[k].angle) continue;
    body.angles = {body.angles[*wanted[k].angle]};
    body.variants = {body.variants[*wanted[k].angle]};
  }
  for (auto& [name, role] : demands.names) role.body = becomes[role.body];
  for (Condition& c : demands.conditions)
    for (auto& [name, role] : c.roles) role.body = becomes[role.body];
}

AskedDemands demands_of(const Asked& asked, const formula::Context& all) { return DemandMaker(asked, all).run(); }

}  // namespace findspace::planning
