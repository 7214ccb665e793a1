// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/nearest_feasible.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "distance/planar/at_position.h"
#include "formula/language/evaluate.h"
#include "formula/language/nearest_contact.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/position_check.h"
#include "formula/planar/regions.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using distance::Coordinates;
using exact::Real;
using exact::RealPoint;

namespace {

NearestFeasible nearest_in_scene(const PreparedWorld& world, const plane::NearestInClosure& found) {
  const plane::Nearest& n = found.nearest;
  return {distance::coordinates(distance::times(world.step(), n.at)), n.distance * world.step(), found.attained};
}

/// A pair's distance at p, in the scene's unit; nothing where it is undefined, or not computed at once.
std::optional<distance::SceneAnswer> value_at(const PreparedWorld& world, const Distance& d, const RealPoint& p) {
  const Roles r = world.roles(d);
  if (r.rotating) return std::nullopt;
  const auto m = world.pair(r.names)->measure(r.which(), p);
  return m ? std::optional(distance::in_scene(*m, world.step())) : std::nullopt;
}

std::optional<NearestFeasible> from_contacts(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  if (world.motion().given()) return std::nullopt;
  const auto steps = [&](const Coordinates& q) { return world.steps({q[0], q[1]}); };
  const ContactWorld asked{[&](const Distance& d, const Coordinates& q) { return value_at(world, d, steps(q)); },
                           [&](std::size_t atom, const Coordinates& q) -> std::optional<int> {
                             return sign_at(world, formula.sign_maps()[formula.sign_map_of(atom)], steps(q));
                           }};
  return nearest_by_contact(asked, formula, distance::coordinates(distance::times(world.step(), p)));
}

/// How far from p a formula holds, at least: a distance changes no faster than the position.
class LeastWay {
 public:
  LeastWay(const PreparedWorld& world, const Formula& formula, const RealPoint& p)
      : world_(world), formula_(formula), p_(p) {}

  Real of(const Node& node) {
    if (node.op == Node::Op::kAtom) return of(formula_.atoms()[node.atom]);
    std::optional<Real> out;
    if (node.op == Node::Op::kAnd || node.op == Node::Op::kOr)
      for (const Node& operand : node.operands) {
        Real way = of(operand);
        if (!out || (node.op == Node::Op::kAnd ? way > *out : way < *out)) out = std::move(way);
      }
    return out.value_or(Real());
  }

 private:
  Real of(const Atom& atom) {
    const Kind kind = atom.distance.kind;
    const bool of_pair = kind == Kind::kGamma1 || kind == Kind::kEta1 || kind == Kind::kDelta1;
    const bool plain = atom.distance.mode == Mode::kPlain && atom.distance.prefix == Extremum::kNone;
    if (!of_pair || !plain || atom.minimum || !atom.more.empty() || world_.motion().given()) return {};
    const std::optional<Real>& value = this->value(atom.distance);
    if (!value || holds(atom, static_cast<std::int8_t>((*value - atom.level).sign()))) return {};
    return abs(*value - atom.level);
  }

  const std::optional<Real>& value(const Distance& d) {
    const auto known = std::find_if(values_.begin(), values_.end(), [&](const auto& v) { return *v.first == d; });
    if (known != values_.end()) return known->second;
    const auto m = value_at(world_, d, p_);
    const bool exact = m && m->proven && !m->minus_infinity;
    return values_.emplace_back(&d, exact ? std::optional(m->value) : std::nullopt).second;
  }

  const PreparedWorld& world_;
  const Formula& formula_;
  RealPoint p_;
  std::vector<std::pair<const Distance*, std::optional<Real>>> values_;
};

/// The nearest of what is nearest in each alternative, but in those that are no nearer anyway.
TriedNearest nearest_of_alternatives(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  LeastWay least(world, formula, p);
  std::vector<std::pair<Real, const Node*>> alternatives;
  for (const Node& node : formula.root().operands) alternatives.emplace_back(least.of(node), &node);
  std::stable_sort(alternatives.begin(), alternatives.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::optional<NearestFeasible> best;
  for (const auto& [way, node] : alternatives) {
    if (best && (best->attained ? way >= best->distance : way > best->distance)) break;
    TriedNearest tried = nearest_feasible_to(world, part_of(formula, *node), p);
    if (!tried) return tried;
    const auto& found = *tried;
    if (!found) continue;
    const bool nearer = !best || found->distance < best->distance;
    if (nearer || (found->attained && !best->attained && found->distance == best->distance)) best = *found;
  }
  return best;
}

}  // namespace

TriedNearest nearest_feasible_to(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  if (auto near = from_contacts(world, formula, p)) return near;
  if (const auto why = between_bounds(world, formula)) return *why;
  if (formula.root().op == Node::Op::kOr) return nearest_of_alternatives(world, formula, p);
  const Real least = LeastWay(world, formula, p).of(formula.root()) / world.step();
  if (const auto near = nearest_in_windows(world, formula, p, least)) return nearest_in_scene(world, *near);
  const plane::Region region = feasible(world, formula), closed = plane::closure(region);
  const auto found = plane::nearest_in_closure(region, closed, p);
  if (!found) return std::nullopt;
  return nearest_in_scene(world, *found);
}

}  // namespace findspace::formula
