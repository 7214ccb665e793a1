// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/rotation_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/rotational_by_angle.h"
#include "exact/margins/formula.h"
#include "formula/language/evaluate.h"
#include "plane/query/moved.h"

namespace findspace::formula {

using distance::BoundedRotations;
using distance::RotationOptimum;
using distance::Sense;
using distance::ValueRange;
using exact::kInfinity;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::RotationMap;

namespace {

/// The best over a set of angles that is known between bounds, or of a distance that is. An angle of within.inner has
/// the value, none of within.outer a better one than the bound. All best angles are among `at`.
RotationOptimum enclosed_best(const RotationMaps& maps, const Distance& d, const RotationBounds& within, Sense sense);

bool is_exact(const RotationBounds& set) {
  const RotationMap open = plane::overlay(std::array<const RotationMap*, 2>{&set.inner, &set.outer},
                                          [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
  return plane::intervals(open).empty();
}

/// The values over an interval of angles, negated for a maximum: the better end is taken by an angle of it.
ValueRange values_over(const RotationMaps& maps, const Distance& wanted, const plane::RotationInterval& angles,
                       Sense sense) {
  const PreparedWorld& world = maps.world();
  const RealPoint& about = maps.about();
  const Distance d = moving_first(wanted, world.world().moving);
  const auto [first, last] = angles.degrees();
  const Real from = Real::from_double(first), to = Real::from_double(last);
  // The ends are known to rounding: a little of the circle about each stands for it.
  const Real about_an_end = Real::from_double(margin::kAboutAnEnd);
  const std::vector<Real> stops{from - about_an_end, from + about_an_end, to - about_an_end, to + about_an_end};
  const auto over = [&](std::size_t first_stop, std::size_t last_stop) {
    std::vector<distance::RotatingPose> poses(2);
    poses[0].moving = stops[first_stop];
    poses[1].moving = stops[last_stop];
    return distance::RotationInTime(plane::moved(world.shape(d.first), {-about.x, -about.y}), world.shape(d.second),
                                    world.which(d), centre_of(world, d), maps.centre(), poses,
                                    world.step().to_double());
  };
  const int rotation = sense == Sense::kMinimum ? 1 : -1;
  const auto better = [rotation](ValueRange v) { return rotation > 0 ? v : ValueRange{-v.high, -v.low}; };
  ValueRange all{kInfinity, kInfinity};
  const auto join = [&](const ValueRange& v, bool taken) {
    all.low = std::min(all.low, v.low);
    if (taken) all.high = std::min(all.high, v.high);
  };
  const distance::PartOfLeg whole{0, Real(0), Real(1)};
  const bool one = first == last;  // no sign: as far as doubles tell
  join(better(over(0, 1).values(whole)), angles.from_in || (one && angles.to_in));
  if (!one) join(better(over(2, 3).values(whole)), angles.to_in);
  if (stops[1] < stops[2]) join(better(over(1, 2).extremum(sense)), true);
  return all;
}

/// The same over a set of angles.
ValueRange values_over(const RotationMaps& maps, const Distance& d, const RotationMap& within, Sense sense) {
  ValueRange all{kInfinity, kInfinity};
  for (const plane::RotationInterval& i : plane::intervals(within)) {
    const ValueRange v = values_over(maps, d, i, sense);
    all = {std::min(all.low, v.low), std::min(all.high, v.high)};
  }
  return all;
}

BoundedRotations bounded_map(const RotationMaps& maps, const SignMap& wanted) {
  if (!maps.rotations_twice(wanted)) {
    RotationMap exact = maps.sign_map(wanted);
    return {exact, exact};
  }
  if (wanted.minimum) {
    const RotationMap all = RotationMap::uniform(1);
    const RotationOptimum least = enclosed_best(maps, wanted.distance, {all, all}, Sense::kMinimum);
    const auto there = plane::remark(least.at, [](Mark m) { return Mark(m > 0 ? 0 : 1); });
    return {there, RotationMap::uniform(1)};
  }
  const PreparedWorld& world = maps.world();
  const Distance d = moving_first(wanted.distance, world.world().moving);
  return distance::rotation_angle_maps({world.shape(d.first), world.shape(d.second), maps.about(), maps.centre()},
                                       world.which(d), centre_of(world, d), wanted.level, world.step().to_double());
}

std::optional<Real> finite(double v) { return std::isinf(v) ? std::nullopt : std::optional(Real::from_double(v)); }

/// The best values over the inner and the outer set, negated for a maximum; +infinity where there is none.
ValueRange best_values(const RotationMaps& maps, const Distance& d, const RotationBounds& within, Sense sense) {
  if (maps.rotations_twice(d)) {
    const ValueRange outer = values_over(maps, d, within.outer, sense);
    return {outer.low, is_exact(within) ? outer.high : values_over(maps, d, within.inner, sense).high};
  }
  const auto number = [&](const RotationMap& set) {
    const RotationOptimum best = maps.best(d, set, sense);
    if (best.unbounded) return -kInfinity;
    const auto value = best.value();
    return value ? (sense == Sense::kMinimum ? 1 : -1) * value->to_double() : kInfinity;
  };
  return {number(within.outer), number(within.inner)};
}

RotationOptimum enclosed_best(const RotationMaps& maps, const Distance& d, const RotationBounds& within, Sense sense) {
  const int rotation = sense == Sense::kMinimum ? 1 : -1;
  const ValueRange best = best_values(maps, d, within, sense);
  auto out = distance::no_optimum<RotationMap>(sense, best.high == -kInfinity);
  out.at = within.outer;
  if (out.unbounded || best.low == kInfinity) return out;
  out.set_enclosed(finite(rotation * best.high), finite(rotation * best.low), distance::Way::kSearch);
  if (std::isinf(best.high)) return out;
  const BoundedRotations near =
      bounded_map(maps, {d, Real::from_double(rotation * (best.high + margin::kBestOfAngles))});
  const RotationMap& bound = rotation > 0 ? near.low : near.high;
  out.at = plane::overlay(std::array<const RotationMap*, 2>{&bound, &within.outer},
                          [rotation](std::span<const Mark> m) { return Mark(m[1] > 0 && rotation * m[0] <= 0); });
  return out;
}

}  // namespace

RotationBounds rotation_bounds(const RotationMaps& rotation, const Formula& formula) {
  std::vector<BoundedRotations> maps;
  for (const SignMap& m : formula.sign_maps()) maps.push_back(bounded_map(rotation, m));
  std::vector<const RotationMap*> operands;
  for (const auto& m : maps) operands.insert(operands.end(), {&m.low, &m.high});
  const RotationMap both =
      plane::overlay(operands, [&](std::span<const Mark> marks) { return certainty(formula, marks); });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

SolvedAngles solve_angles(const RotationMaps& maps, const Formula& formula) {
  if (!maps.rotations_twice(formula)) return {maps.feasible(formula), std::nullopt};
  RotationBounds bounds = rotation_bounds(maps, formula);
  return {std::move(bounds.inner), std::move(bounds.outer)};
}

BestAngles best_angles(const RotationMaps& maps, const Distance& d, const SolvedAngles& within, Sense sense) {
  const bool exact = !within.outer && !maps.rotations_twice(d);
  RotationOptimum best =
      exact ? maps.best(d, within.angles, sense)
            : enclosed_best(maps, d, {within.angles, within.outer ? *within.outer : within.angles}, sense);
  BestAngles out{best, {}};
  if (exact)
    out.at = {std::move(best.at), std::nullopt};
  else
    out.at = {RotationMap::uniform(0), std::move(best.at)};
  return out;
}

}  // namespace findspace::formula
