// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solver at one position: values with their witnesses, signs, check.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "findspace/error.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/language/which.h"
#include "formula/planar/solve.h"
#include "plane/base/parallel.h"

namespace findspace::formula {

using exact::Real;
using exact::RealPoint;
using plane::Mark;

namespace {

/// What is 0 where a distance along a direction is, and has two features there.
distance::Which touching(distance::Which w) {
  using distance::Which;
  if (w == Which::kEta1 || w == Which::kEta2) return Which::kMu;
  return w == Which::kDelta1 || w == Which::kDelta2 ? Which::kMuBack : Which::kD1;
}

constexpr double kClear = 0x1p-34;  // of the sizes; values at a position are right to far less

}  // namespace

DistanceAt Solver::value(const Distance& wanted, const RealPoint& p) const {
  DistanceAt out;
  out.text = text(wanted);
  out.in_degrees = wanted.mode == Mode::kRotation;
  const Roles r = roles(wanted);
  const bool rotation = r.wanted.mode == Mode::kRotation;
  if (r.rotating || (rotation && world_.motion.given())) {
    const auto v = rotation_value(r, p);
    const double unit = rotation ? 1 : world_.step.to_double();
    if (v) {
      out.value = shown(*v, r) * unit;
      out.bound = v->low == v->high ? 0 : (v->high - v->low) * unit;
    }
    return out;
  }
  if (!world_.motion.given() && r.wanted.mode == Mode::kPlain) {
    auto pair = this->pair(r.names);
    if (auto m = pair->measure(formula::which(r.wanted.kind, r.second_moves), p))
      add_witness(out, wanted, r.names, *pair, *m, p);
    return out;
  }
  auto v = function(wanted)->value(p);
  if (v && v->minus_infinity)
    out.value = -std::numeric_limits<double>::infinity();
  else if (v) {
    out.value = (v->value * world_.step).to_double();
    out.nearest = v->nearest;
  }
  if (out.nearest && !world_.motion.given()) add_contact(out, wanted, r, p);
  return out;
}

void Solver::add_witness(DistanceAt& out, const Distance& wanted, const Names& names, const distance::AtPosition& pair,
                         const distance::Measured& m, const RealPoint& p) const {
  out.value = m.minus_infinity ? -std::numeric_limits<double>::infinity() : (m.value * world_.step).to_double();
  out.nearest = m.nearest;
  out.farthest = m.farthest;
  out.witness = named_features(wanted, names, pair, m, p);
}

std::vector<FeatureAt> Solver::named_features(const Distance& wanted, const Names& names,
                                              const distance::AtPosition& pair, const distance::Measured& m,
                                              const RealPoint& p) const {
  std::vector<FeatureAt> out;
  for (const distance::Feature& f : m.witness)
    out.push_back(named_feature(f, f.of_moving ? pair.pair().moving() : pair.pair().fixed(),
                                f.of_moving ? names.first : names.second, world_.shapes, world_.parts, p));
  bool rotated = wanted.first == names.second && !out.empty() && m.witness[0].of_moving != m.witness[1].of_moving;
  if (rotated) std::swap(out[0], out[1]);
  return out;
}

void Solver::add_contact(DistanceAt& out, const Distance& wanted, const Roles& r, const RealPoint& p) const {
  const auto pair = this->pair(r.names);
  const RealPoint& there = *out.nearest;
  const auto m = pair->measure(touching(formula::which(r.wanted.kind, r.second_moves)), there);
  if (!m || m->witness.size() != 2 || m->witness[0].of_moving == m->witness[1].of_moving) return;
  out.witness = named_features(wanted, r.names, *pair, *m, there);
  // The moving one's feature, back from where they touch.
  FeatureAt& moving = out.witness[m->witness[0].of_moving != (wanted.first == r.names.second) ? 0 : 1];
  moving.at = {moving.at.x + p.x - there.x, moving.at.y + p.y - there.y};
}

/// Of an extremum over time the end that f is known to take.
double Solver::shown(const distance::ValueRange& v, const Roles& r) const {
  const bool instant = !world_.motion.given() || (world_.instant && r.wanted.prefix == Extremum::kNone);
  if (std::isinf(v.low) || std::isinf(v.high)) return std::isinf(v.low) ? v.high : v.low;
  if (instant) return v.middle();
  return natural_extremum(r.wanted) == Extremum::kInf ? v.high : v.low;
}

/// From the value, where it is clearly not the level: no map of all positions is made then.
std::optional<std::int8_t> Solver::clear_sign(const SignMap& wanted, const Roles& r, const RealPoint& p) const {
  if (wanted.minimum || world_.motion.given() || r.wanted.mode != Mode::kPlain) return std::nullopt;
  const auto m = pair(r.names)->measure(formula::which(r.wanted.kind, r.second_moves), p);
  if (!m) return std::int8_t(1);
  if (m->minus_infinity) return std::int8_t(-1);
  const double value = m->value.to_double(), level = (wanted.level / world_.step).to_double();
  const double size = std::abs(value) + std::abs(level) + pair(r.names)->scale(p);
  if (std::abs(value - level) <= size * kClear) return std::nullopt;
  return std::int8_t(value > level ? 1 : -1);
}

std::int8_t Solver::sign(const SignMap& asked, const RealPoint& p) const {
  const SignMap wanted = plain_level(asked);
  const Roles r = roles(wanted.distance);
  const bool rotation = in_rotation(wanted);
  if (!r.rotating && !(rotation && world_.motion.given())) {
    if (const auto clear = clear_sign(wanted, r, p)) return *clear;
    const plane::SignMap m = sign_map(wanted);
    return mark_of(m, locate(m, p));
  }
  if (wanted.minimum) refuse(wanted.distance, "whether a position is the best of all is not computed with a motion");
  const bool at_instant = world_.instant && wanted.distance.prefix == Extremum::kNone;
  const auto exact = at_instant ? std::nullopt : swing_sign(wanted, {p.x * world_.step, p.y * world_.step});
  if (exact) return *exact;
  if (rotation && at_instant) {
    const distance::SignRange s = rotation_in_time(r, p, true).signs({0, Real(), Real()}, wanted.level);
    if (s.low == s.high) return s.low;
  }
  const auto v = rotation_value(r, p);
  if (!v) return 1;
  const double level = (rotation ? wanted.level : wanted.level / world_.step).to_double();
  const double tolerance = (std::abs(level) + 1) * 0x1p-50;
  if (v->low > level + tolerance) return 1;
  if (v->high < level - tolerance) return -1;
  const double unit = rotation ? 1 : world_.step.to_double();
  refuse(wanted.distance,
         fmt::format(
             "over time, in rotation or of shapes that turn, it lies between {:.10g} and {:.10g} here: too near to "
             "the level to decide",
             v->low * unit, v->high * unit));
}

Solver::Check Solver::check(const Formula& formula, const RealPoint& position) const {
  RealPoint p = steps(position);
  std::vector<std::int8_t> signs(formula.sign_maps().size());
  plane::parallel_for(signs.size(), [&](std::size_t k) { signs[k] = sign(formula.sign_maps()[k], p); });
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    AtomAt a{atom, value(atom.distance, p), holds(atom, signs[formula.sign_map_of(k)]), std::nullopt};
    if (!a.holds && a.distance.value && std::isfinite(*a.distance.value) && !atom.minimum)
      a.lacks = std::abs(*a.distance.value - atom.level.to_double());
    out.atoms.push_back(std::move(a));
  }
  return out;
}

}  // namespace findspace::formula
