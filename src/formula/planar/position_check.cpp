// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/position_check.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "exact/number/margins.h"
#include "formula/language/evaluate.h"
#include "formula/planar/measure.h"
#include "formula/planar/regions.h"
#include "formula/planar/rotation_values.h"
#include "formula/planar/swing.h"
#include "plane/base/parallel.h"

namespace findspace::formula {

using exact::Real;
using exact::RealPoint;

namespace {

/// From the value, where it is clearly not the level: no map of all positions is made then.
std::optional<std::int8_t> clear_sign(const PreparedWorld& world, const SignMap& wanted, const Roles& r,
                                      const RealPoint& p) {
  if (wanted.minimum || world.motion().given() || r.wanted.mode != Mode::kPlain) return std::nullopt;
  const auto m = world.pair(r.names)->measure(r.which(), p);
  if (!m) return std::int8_t(1);
  if (m->minus_infinity) return std::int8_t(-1);
  const double value = m->value.to_double(), level = (wanted.level / world.step()).to_double();
  const double size = std::abs(value) + std::abs(level) + world.pair(r.names)->scale(p);
  if (std::abs(value - level) <= size * margin::kClearOfLevel) return std::nullopt;
  return std::int8_t(value > level ? 1 : -1);
}

}  // namespace

std::int8_t sign_at(const PreparedWorld& world, const SignMap& asked, const RealPoint& p) {
  const SignMap wanted = plain_level(asked);
  const Roles r = world.roles(wanted.distance);
  const bool rotation = in_rotation(wanted);
  if (!r.rotating && !(rotation && world.motion().given())) {
    if (const auto clear = clear_sign(world, wanted, r, p)) return *clear;
    const plane::SignMap m = sign_map(world, wanted);
    return mark_of(m, locate(m, p));
  }
  if (wanted.minimum) refuse(wanted.distance, "whether a position is the best of all is not computed with a motion");
  const bool at_instant = world.world().instant && wanted.distance.prefix == Extremum::kNone;
  const auto exact = at_instant ? std::nullopt : swing_sign(world, wanted, p);
  if (exact) return *exact;
  if (rotation && at_instant) {
    const distance::SignRange s = rotation_in_time(world, r, p, true).signs({0, Real(), Real()}, wanted.level);
    if (s.low == s.high) return s.low;
  }
  const auto v = rotation_value(world, r, p);
  if (!v) return 1;
  const double level = (rotation ? wanted.level : wanted.level / world.step()).to_double();
  const double tolerance = (std::abs(level) + 1) * margin::kRangeAtLevel;
  if (v->low > level + tolerance) return 1;
  if (v->high < level - tolerance) return -1;
  const double unit = rotation ? 1 : world.step().to_double();
  refuse(wanted.distance,
         fmt::format(
             "over time, in rotation or of shapes that turn, it lies between {:.10g} and {:.10g} here: too near to "
             "the level to decide",
             v->low * unit, v->high * unit));
}

Check check_at(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  std::vector<std::int8_t> signs(formula.sign_maps().size());
  plane::parallel_for(signs.size(), [&](std::size_t k) { signs[k] = sign_at(world, formula.sign_maps()[k], p); });
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    AtomAt a{atom, distance_at(world, atom.distance, p), holds(atom, signs[formula.sign_map_of(k)]), std::nullopt};
    if (!a.holds && a.distance.value && std::isfinite(*a.distance.value) && !atom.minimum)
      a.lacks = std::abs(*a.distance.value - atom.level.to_double());
    out.atoms.push_back(std::move(a));
  }
  return out;
}

}  // namespace findspace::formula
