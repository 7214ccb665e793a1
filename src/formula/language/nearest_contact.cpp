// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/language/nearest_contact.h"

#include <algorithm>

#include "formula/language/evaluate.h"

namespace findspace::formula {

using distance::Coordinates;
using exact::Real;

namespace {

bool is_conjunction(const Node& node) {
  const auto is_atom = [](const Node& n) { return n.op == Node::Op::kAtom; };
  return is_atom(node) ||
         (node.op == Node::Op::kAnd && std::all_of(node.operands.begin(), node.operands.end(), is_atom));
}

/// The farthest point of one shape has a nearest point of the other.
bool is_directed(Kind kind) { return kind == Kind::kMu || kind == Kind::kH || kind == Kind::kHausdorff; }

/// Of an atom whose distance changes no faster than the position, and has a nearest contact, or such points.
bool is_simple(const Atom& atom) {
  const Kind kind = atom.distance.kind;
  const bool is_signed = kind == Kind::kGamma1 || kind == Kind::kEta1 || kind == Kind::kDelta1;
  return !atom.minimum && atom.more.empty() && atom.distance.mode == Mode::kPlain && (is_signed || is_directed(kind)) &&
         atom.relation != Relation::kNotEqual;
}

/// Where the two points of a directed distance would come together, with B moved there from p.
std::optional<Coordinates> joined(const distance::SceneAnswer& m, const Coordinates& p) {
  if (m.value.sign() <= 0 || m.witness.size() != 2 || m.witness[0].of_moving == m.witness[1].of_moving)
    return std::nullopt;
  const auto& moving = m.witness[m.witness[0].of_moving ? 0 : 1].at;
  const auto& fixed = m.witness[m.witness[0].of_moving ? 1 : 0].at;
  Coordinates out = p;
  for (std::size_t k = 0; k < p.size(); ++k) out[k] += fixed[k] - moving[k];
  return out;
}

/// p - by * unit
Coordinates behind(const Coordinates& p, const Real& by, const Coordinates& unit) {
  Coordinates out = p;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] -= by * unit[k];
  return out;
}

/// Of a gap that is to be greater, where a straight way does not lead to the level.
std::optional<NearestFeasible> apart(const ContactWorld& world, const Atom& atom, const Coordinates& p) {
  const bool greater = atom.relation == Relation::kGreaterEqual || atom.relation == Relation::kEqual;
  if (!world.apart || !is_simple(atom) || atom.distance.kind != Kind::kGamma1 || !greater) return std::nullopt;
  const auto m = world.value(atom.distance, p);
  if (!m || !(m->minus_infinity || m->value < atom.level)) return std::nullopt;
  const auto at = world.apart(atom.distance, atom.level, p);
  if (!at) return std::nullopt;
  Real square;
  for (std::size_t k = 0; k < p.size(); ++k) square += ((*at)[k] - p[k]) * ((*at)[k] - p[k]);
  return NearestFeasible{*at, sqrt(square), true};
}

/// The nearest position at which the atom holds, or which `<` or `>` has as its limit.
std::optional<NearestFeasible> contact(const ContactWorld& world, const Atom& atom, const Coordinates& p) {
  if (!is_simple(atom)) return std::nullopt;
  const auto m = world.value(atom.distance, p);
  if (!m || !m->proven || m->minus_infinity || m->value.sign() == 0) return std::nullopt;
  const bool directed = is_directed(atom.distance.kind);
  const std::optional<Coordinates> to = directed ? joined(*m, p) : m->nearest;
  if (!to) return std::nullopt;
  // From p in this direction the value grows as fast as it can, to the nearest contact at least.
  Coordinates unit = p;
  for (std::size_t k = 0; k < p.size(); ++k) unit[k] = (p[k] - (*to)[k]) / m->value;
  const Real fall = m->value - atom.level;
  const auto falls_by = [&](const Real& by) {
    const Coordinates at = behind(p, by, unit);
    const Real wanted = m->value - by;
    if (world.more(atom.distance, wanted, at)) return false;
    const auto there = world.value(atom.distance, at);
    return there && there->proven && !there->minus_infinity && there->value == wanted;
  };
  const bool limit = !holds(atom, 0);
  const bool to_contact = !directed && fall.sign() == m->value.sign() && !(abs(fall) > abs(m->value));
  // `<` and `>` hold as near to the level as one likes if they do all the way from it to here.
  const Real beyond = fall.sign() != 0 ? fall * Real::ratio(1025, 1024)
                                       : abs(m->value) * Real::ratio(atom.relation == Relation::kLess ? 1 : -1, 1024);
  if (limit ? !falls_by(beyond) : !to_contact && !falls_by(fall)) return std::nullopt;
  return NearestFeasible{behind(p, fall, unit), abs(fall), !limit};
}

}  // namespace

std::optional<NearestFeasible> nearest_by_contact(const ContactWorld& world, const Formula& formula,
                                                  const Coordinates& p) {
  if (!is_conjunction(formula.root())) return std::nullopt;
  const auto holds_at = [&](std::size_t atom, const Coordinates& q) {
    const auto sign = world.sign(atom, q);
    return sign && holds(formula.atoms()[atom], static_cast<std::int8_t>(*sign));
  };
  // By continuity all around then, too.
  const auto is_off_its_level = [&](std::size_t atom, const Coordinates& q) {
    const Atom& a = formula.atoms()[atom];
    return !a.minimum && a.more.empty() && a.distance.mode == Mode::kPlain && world.sign(atom, q).value_or(0) != 0;
  };
  std::optional<NearestFeasible> farthest;
  std::size_t decides = 0;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    if (holds_at(k, p)) continue;
    auto c = contact(world, formula.atoms()[k], p);
    if (!c) c = apart(world, formula.atoms()[k], p);
    if (!c) return std::nullopt;
    if (!farthest || c->distance > farthest->distance) {
      farthest = std::move(c);
      decides = k;
    }
  }
  if (!farthest) return std::nullopt;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    if (k == decides) continue;
    if (!holds_at(k, farthest->at)) return std::nullopt;
    if (!farthest->attained && !is_off_its_level(k, farthest->at)) return std::nullopt;
  }
  return farthest;
}

}  // namespace findspace::formula
