// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/position_check.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "distance/planar/at_position.h"
#include "exact/margins/formula.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/planar/measure.h"
#include "formula/planar/regions.h"
#include "formula/planar/rotation_values.h"
#include "formula/planar/sums.h"
#include "formula/planar/swing.h"
#include "plane/base/parallel.h"
#include "plane/base/stopwatch.h"

namespace findspace::formula {

using distance::Way;
using exact::Real;
using exact::RealPoint;

namespace {

/// From the value, where it is clearly not the level: no map of all positions is made then.
std::optional<DecidedSign> clear_sign(const PreparedWorld& world, const SignMap& wanted, const Roles& r,
                                      const std::optional<distance::PlanarAnswer>& m, const RealPoint& p) {
  if (!m) return DecidedSign{1, Way::kFeatures};
  if (m->minus_infinity) return DecidedSign{-1, m->way, m};
  const double level = (wanted.level / world.step()).to_double();
  const distance::Enclosure within = m->bounds();
  if (!within.lower || !within.upper) return std::nullopt;
  const double low = within.lower->to_double(), high = within.upper->to_double();
  const double size = std::max(std::abs(low), std::abs(high)) + std::abs(level) + world.pair(r.names)->scale(p);
  const double tolerance = size * margin::kClearOfLevel;
  if (low - level > tolerance) return DecidedSign{1, m->way, m};
  if (level - high > tolerance) return DecidedSign{-1, m->way, m};
  return std::nullopt;
}

/// Exactly where every summand has an exact value, else by their bounds.
DecidedSign sum_sign(const PreparedWorld& world, const SignMap& wanted, const RealPoint& p) {
  const distance::DistanceSum sum = distance_sum(world, terms_of(wanted));
  const auto sign = sum.sign(p, wanted.level / world.step());
  if (!sign)
    refuse(wanted.distance, sum.infinite(p)
                                ? "the sum that it is part of is too near to the level here to decide"
                                : "two distances of the sum that it is part of are infinite, with opposite signs");
  return {std::int8_t(*sign), Way::kMap};
}

}  // namespace

DecidedSign decided_sign(const PreparedWorld& world, const SignMap& asked, const RealPoint& p) {
  if (!asked.more.empty()) return sum_sign(world, asked, p);
  const SignMap wanted = plain_level(asked);
  const Roles r = world.roles(wanted.distance);
  const bool rotation = in_rotation(wanted);
  if (!r.rotating && !(rotation && world.motion().given())) {
    std::optional<distance::PlanarAnswer> value;
    if (!wanted.minimum && !world.motion().given() && r.wanted.mode == Mode::kPlain) {
      value = world.pair(r.names)->measure(r.which(), p);
      if (auto clear = clear_sign(world, wanted, r, value, p)) return *std::move(clear);
    }
    auto map = world.kept_maps().find(wanted);
    if (!map) map = world.kept_maps().keep(wanted, sign_map(world, wanted));
    return {mark_of(*map, locate(*map, p)), Way::kMap, std::move(value)};
  }
  if (wanted.minimum) refuse(wanted.distance, "whether a position is the best of all is not computed with a motion");
  const bool at_instant = world.world().instant && wanted.distance.prefix == Extremum::kNone;
  if (auto rest = at_rest(world, wanted.distance, p)) {
    DecidedSign out = decided_sign(*rest->world, {std::move(rest->distance), wanted.level}, rest->at);
    out.value.reset();  // its features are elsewhere
    return out;
  }
  const auto exact = at_instant ? std::nullopt : swing_sign(world, wanted, p);
  if (exact) return {*exact, Way::kAngles};
  if (rotation && at_instant) {
    const distance::SignRange s = rotation_in_time(world, r, p, true).signs({0, Real(), Real()}, wanted.level);
    if (s.low == s.high) return {s.low, Way::kAngles};
  }
  const auto v = rotation_value(world, r, p);
  if (!v) return {1, Way::kSearch};
  const double level = (rotation ? wanted.level : wanted.level / world.step()).to_double();
  const double tolerance = (std::abs(level) + 1) * margin::kRangeAtLevel;
  if (v->low > level + tolerance) return {1, Way::kSearch};
  if (v->high < level - tolerance) return {-1, Way::kSearch};
  // After the bounds, which take less time than a map over all angles.
  if (const auto now = at_instant ? swing_sign(world, wanted, p) : std::nullopt) return {*now, Way::kAngles};
  const double unit = rotation ? 1 : world.step().to_double();
  const bool minus = negated(wanted.distance);
  refuse(wanted.distance,
         fmt::format(
             "over time, in rotation or of shapes that rotate, it lies between {:.10g} and {:.10g} here: too near to "
             "the level to decide",
             unit * (minus ? -v->high : v->low), unit * (minus ? -v->low : v->high)));
}

std::int8_t sign_at(const PreparedWorld& world, const SignMap& wanted, const RealPoint& p) {
  return decided_sign(world, wanted, p).sign;
}

bool holds_at(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  std::vector<std::optional<std::int8_t>> known(formula.sign_maps().size());
  std::int32_t at = formula.entry();
  while (at >= 0) {
    const Instruction& step = formula.program()[std::size_t(at)];
    auto& sign = known[step.sign_map];
    if (!sign) sign = sign_at(world, formula.sign_maps()[step.sign_map], p);
    at = (step.accepted >> (*sign + 1) & 1u) != 0 ? step.on_true : step.on_false;
  }
  return at == Instruction::kTrue;
}

Check check_at(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  const std::size_t count = formula.sign_maps().size();
  std::vector<std::int8_t> signs(count);
  std::vector<DecidedSign> decisions(count);
  std::vector<double> milliseconds(count);
  plane::parallel_for(count, [&](std::size_t k) {
    const plane::Stopwatch watch;
    decisions[k] = decided_sign(world, formula.sign_maps()[k], p);
    signs[k] = decisions[k].sign;
    milliseconds[k] = watch.milliseconds();
  });
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    const std::size_t map = formula.sign_map_of(k);
    const plane::Stopwatch watch;
    const auto& known = decisions[map].value;
    const bool same = known && atom.more.empty() && atom.distance.mode == Mode::kPlain &&
                      atom.distance == formula.sign_maps()[map].distance;
    DistanceAt value = same                ? plain_distance_at(world, atom.distance, *known, p)
                       : atom.more.empty() ? distance_at(world, atom.distance, p)
                                           : sum_at(world, formula.sign_maps()[map], written_sum(atom), p);
    if (value.answer && !atom.minimum && atom.more.empty())
      value.answer = distance::narrowed(*std::move(value.answer), atom.level, signs[map]);
    out.atoms.push_back(atom_at(atom, std::move(value), signs[map]));
    out.atoms.back().way = decisions[map].way;
    out.atoms.back().milliseconds = milliseconds[map] + watch.milliseconds();
  }
  return out;
}

}  // namespace findspace::formula
