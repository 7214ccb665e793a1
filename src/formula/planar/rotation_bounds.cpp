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
using distance::Sense;
using distance::ValueRange;
using exact::kInfinity;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::RotationMap;

namespace {

/// The least or greatest value over a set of angles that is known between bounds, or of a distance that is.
struct BestRotation {
  std::optional<double> value;  // in the scene's unit, or in degrees: of an angle of within.inner; or none
  double bound = 0;             // no angle of within.outer has a better one
  bool none = false;            // proven: there are no values, or none is the last
  plane::RotationMap possible;  // all best angles are among these
};
BestRotation best_rotation(const RotationMaps& maps, const Distance& d, const RotationBounds& within, Sense sense);

double way_of(const plane::RotationInterval& i) {
  const double d = i.to.degrees() - i.from.degrees();
  return d < 0 ? d + 360 : d;
}

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
  const double first = angles.from.degrees(), way = angles.round ? 360 : way_of(angles);
  const Real from = Real::from_double(first), to = Real::from_double(first + way);
  // The ends are known to rounding: a little of the circle about each stands for it.
  const Real about_an_end = Real::from_double(margin::kAboutAnEnd);
  const std::vector<Real> stops{from - about_an_end, from + about_an_end, to - about_an_end, to + about_an_end};
  const auto over = [&](std::size_t first_stop, std::size_t last_stop) {
    std::vector<distance::RotatingPose> poses(2);
    poses[0].moving = stops[first_stop];
    poses[1].moving = stops[last_stop];
    return distance::RotationInTime(plane::moved(world.shape(d.first), {-about.x, -about.y}), world.shape(d.second),
                                    world.which(d), centre_of(world, d), maps.centre(), poses);
  };
  const int rotation = sense == Sense::kMinimum ? 1 : -1;
  const auto better = [rotation](ValueRange v) { return rotation > 0 ? v : ValueRange{-v.high, -v.low}; };
  ValueRange all{kInfinity, kInfinity};
  const auto join = [&](const ValueRange& v, bool taken) {
    all.low = std::min(all.low, v.low);
    if (taken) all.high = std::min(all.high, v.high);
  };
  const distance::PartOfLeg whole{0, Real(0), Real(1)};
  join(better(over(0, 1).values(whole)), angles.from_in);
  if (way > 0) join(better(over(2, 3).values(whole)), angles.to_in);
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
    const BestRotation least = best_rotation(maps, wanted.distance, {all, all}, Sense::kMinimum);
    const auto there = plane::remark(least.possible, [](Mark m) { return Mark(m > 0 ? 0 : 1); });
    return {there, RotationMap::uniform(1)};
  }
  const PreparedWorld& world = maps.world();
  const Distance d = moving_first(wanted.distance, world.world().moving);
  return distance::rotation_angle_maps({world.shape(d.first), world.shape(d.second), maps.about(), maps.centre()},
                                       world.which(d), centre_of(world, d), wanted.level);
}

BestRotation best_rotation(const RotationMaps& maps, const Distance& d, const RotationBounds& within, Sense sense) {
  const int rotation = sense == Sense::kMinimum ? 1 : -1;
  BestRotation out{std::nullopt, 0, false, RotationMap::uniform(0)};
  double value = kInfinity;
  if (maps.rotations_twice(d)) {
    const ValueRange outer = values_over(maps, d, within.outer, sense);
    value = is_exact(within) ? outer.high : values_over(maps, d, within.inner, sense).high;
    out.bound = rotation * outer.low;
  } else {
    const auto exact = [&](const RotationMap& set) {
      return rotation > 0 ? maps.least(d, set) : maps.greatest(d, set);
    };
    const plane::RotationLeast inner = exact(within.inner), outer = exact(within.outer);
    if (inner.exists) value = rotation * inner.value.to_double();
    out.bound = outer.exists ? outer.value.to_double() : rotation * kInfinity;
  }
  if (std::isinf(value)) {
    out.none = value < 0 || rotation * out.bound == kInfinity;
    out.possible = within.outer;
    return out;
  }
  out.value = rotation * value;
  const BoundedRotations near =
      bounded_map(maps, {d, Real::from_double(rotation * value + rotation * margin::kBestOfAngles)});
  const RotationMap& bound = rotation > 0 ? near.low : near.high;
  out.possible = plane::overlay(std::array<const RotationMap*, 2>{&bound, &within.outer},
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
  BestAngles out;
  if (!within.outer && !maps.rotations_twice(d)) {
    plane::RotationLeast best =
        sense == Sense::kMinimum ? maps.least(d, within.angles) : maps.greatest(d, within.angles);
    out.at.angles = std::move(best.at);
    out.proven = !best.exists || best.proven;
    out.attained = best.exists && best.attained;
    if (best.exists) out.value = best.value.to_double();
    return out;
  }
  BestRotation best = best_rotation(maps, d, {within.angles, within.outer ? *within.outer : within.angles}, sense);
  out.value = best.value;
  out.proven = best.none;
  if (!best.none) out.bound = best.bound;
  out.at = {RotationMap::uniform(0), std::move(best.possible)};
  return out;
}

}  // namespace findspace::formula
