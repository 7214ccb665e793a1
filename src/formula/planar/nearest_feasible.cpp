// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/nearest_feasible.h"

#include <algorithm>

#include "formula/language/evaluate.h"
#include "formula/planar/position_check.h"
#include "formula/planar/regions.h"
#include "plane/base/real_vector.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::operator*;
using plane::operator-;

namespace {

bool is_conjunction(const Node& node) {
  const auto is_atom = [](const Node& n) { return n.op == Node::Op::kAtom; };
  return is_atom(node) ||
         (node.op == Node::Op::kAnd && std::all_of(node.operands.begin(), node.operands.end(), is_atom));
}

NearestFeasible nearest_in_scene(const PreparedWorld& world, const plane::Nearest& n, bool attained) {
  return {distance::coordinates(distance::times(world.step(), n.at)), n.distance * world.step(), attained};
}

bool is_signed(Kind kind) { return kind == Kind::kGamma1 || kind == Kind::kEta1 || kind == Kind::kDelta1; }

/// The nearest position at which the atom holds, or which `<` or `>` has as its limit, and its distance in grid steps.
std::optional<plane::Nearest> contact(const PreparedWorld& world, const Atom& atom, const RealPoint& p) {
  const Roles r = world.roles(atom.distance);
  const bool simple =
      !atom.minimum && atom.more.empty() && !r.rotating && r.wanted.mode == Mode::kPlain && is_signed(r.wanted.kind);
  if (!simple || atom.relation == Relation::kNotEqual) return std::nullopt;
  const auto pair = world.pair(r.names);
  const distance::Which which = r.which();
  const auto m = pair->measure(which, p);
  if (!m || m->minus_infinity || !m->nearest) return std::nullopt;
  // From p in this direction the value grows as fast as it can, to the nearest contact at least.
  const RealPoint unit = (Real(1) / m->value) * (p - *m->nearest);
  const Real fall = m->value - atom.level / world.step();
  const auto falls_by = [&](const Real& by) {
    const auto there = pair->measure(which, p - by * unit);
    return there && !there->minus_infinity && there->value == m->value - by;
  };
  const bool limit = !holds(atom, 0), to_contact = fall.sign() == m->value.sign() && !(abs(fall) > abs(m->value));
  if (limit ? !falls_by(fall * Real::ratio(1025, 1024)) : !to_contact && !falls_by(fall)) return std::nullopt;
  return plane::Nearest{abs(fall), p - fall * unit, {}};
}

std::optional<NearestFeasible> nearest_by_contact(const PreparedWorld& world, const Formula& formula,
                                                  const RealPoint& p) {
  if (world.motion().given() || !is_conjunction(formula.root())) return std::nullopt;
  const auto holds_at = [&](std::size_t atom, const RealPoint& q) {
    return holds(formula.atoms()[atom], sign_at(world, formula.sign_maps()[formula.sign_map_of(atom)], q));
  };
  // By continuity all around then, too.
  const auto is_off_its_level = [&](std::size_t atom, const RealPoint& q) {
    const Atom& a = formula.atoms()[atom];
    return !a.minimum && a.distance.mode == Mode::kPlain &&
           sign_at(world, formula.sign_maps()[formula.sign_map_of(atom)], q) != 0;
  };
  std::optional<plane::Nearest> farthest;
  std::size_t decides = 0;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    if (holds_at(k, p)) continue;
    auto c = contact(world, formula.atoms()[k], p);
    if (!c) return std::nullopt;
    if (!farthest || c->distance > farthest->distance) {
      farthest = std::move(c);
      decides = k;
    }
  }
  if (!farthest) return std::nullopt;
  const bool attained = holds(formula.atoms()[decides], 0);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    if (k == decides) continue;
    if (!holds_at(k, farthest->at)) return std::nullopt;
    if (!attained && !is_off_its_level(k, farthest->at)) return std::nullopt;
  }
  return nearest_in_scene(world, *farthest, attained);
}

}  // namespace

exact::Tried<std::optional<NearestFeasible>> nearest_feasible_to(const PreparedWorld& world, const Formula& formula,
                                                                 const RealPoint& p) {
  if (auto found = nearest_by_contact(world, formula, p)) return found;
  if (const auto why = between_bounds(world, formula)) return *why;
  plane::Region region = feasible(world, formula), closed = plane::closure(region);
  auto in = [](Mark m) { return m > 0; };
  auto here = mark_of(closed, locate(closed, p)) > 0;
  auto n = here ? std::optional(plane::Nearest{Real(), p, {}}) : plane::nearest(closed, in, p);
  if (!n) return std::nullopt;
  return nearest_in_scene(world, *n, mark_of(region, locate(region, n->at)) > 0);
}

}  // namespace findspace::formula
