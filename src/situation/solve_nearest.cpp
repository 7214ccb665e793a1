// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solver: the nearest feasible position, min {|q - p| : the formula holds at q}, or of the closure of those. Where all
// atoms must hold and those that fail compare gamma1, eta1 or delta1 with 0, no map is made: such a distance is that of
// p to the positions where the atom holds, so no feasible position is nearer than the farthest of their contacts, and
// if the other atoms hold there it is the nearest. Else the whole region is made. Guarantee: exact. Keywords: closest
// feasible configuration, minimum translation.

#include <algorithm>

#include "plane/nearest.h"
#include "plane/topology.h"
#include "situation/evaluate.h"
#include "situation/solve.h"
#include "situation/which.h"

namespace findspace::situation {

using exact::Real;
using exact::RealPoint;
using plane::Mark;

namespace {

bool is_conjunction(const Node& node) {
  const auto is_atom = [](const Node& n) { return n.op == Node::Op::kAtom; };
  return is_atom(node) ||
         (node.op == Node::Op::kAnd && std::all_of(node.operands.begin(), node.operands.end(), is_atom));
}

bool is_signed(Kind kind) { return kind == Kind::kGamma1 || kind == Kind::kEta1 || kind == Kind::kDelta1; }

}  // namespace

/// The contact that makes the atom hold: the nearest position at which it does, and its distance in grid steps.
std::optional<plane::Nearest> Solver::contact(const Atom& atom, const RealPoint& p) const {
  const Roles r = roles(atom.distance);
  const bool simple = !atom.minimum && !r.turning && r.wanted.mode == Mode::kPlain && is_signed(r.wanted.kind);
  if (!simple || atom.level.sign() != 0 || !holds(atom, 0)) return std::nullopt;
  const auto m = pair(r.names)->measure(situation::which(r.wanted.kind, r.second_moves), p);
  if (!m || m->minus_infinity || !m->nearest) return std::nullopt;
  return plane::Nearest{m->value.sign() < 0 ? -m->value : m->value, *m->nearest, {}};
}

std::optional<NearestFeasible> Solver::nearest_by_contact(const Formula& formula, const RealPoint& p) const {
  if (world_.motion.given() || !is_conjunction(formula.root())) return std::nullopt;
  const auto holds_at = [&](std::size_t atom, const RealPoint& q) {
    return holds(formula.atoms()[atom], sign(formula.sign_maps()[formula.sign_map_of(atom)], q));
  };
  std::optional<plane::Nearest> farthest;
  std::size_t decides = 0;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    if (holds_at(k, p)) continue;
    auto c = contact(formula.atoms()[k], p);
    if (!c) return std::nullopt;
    if (!farthest || c->distance > farthest->distance) farthest = std::move(c), decides = k;
  }
  if (!farthest) return std::nullopt;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k)
    if (k != decides && !holds_at(k, farthest->at)) return std::nullopt;
  return NearestFeasible{farthest->at, farthest->distance * world_.step, true};
}

std::optional<NearestFeasible> Solver::nearest_feasible(const Formula& formula, const RealPoint& position) const {
  const RealPoint p = steps(position);
  if (auto found = nearest_by_contact(formula, p)) return found;
  plane::Region region = feasible(formula), closed = plane::closure(region);
  auto in = [](Mark m) { return m > 0; };
  auto here = mark_of(closed, locate(closed, p)) > 0;
  auto n = here ? std::optional(plane::Nearest{Real(), p, {}}) : plane::nearest(closed, in, p);
  if (!n) return std::nullopt;
  return NearestFeasible{n->at, n->distance * world_.step, mark_of(region, locate(region, n->at)) > 0};
}

}  // namespace findspace::situation
