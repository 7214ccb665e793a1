// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// RotationSolver where angles are known between bounds only: distances in rotation about another point than the moving
// shape rotates about, at levels other than 0 (rotation_angles.h).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "distance/rotation/rotation_angles.h"
#include "distance/rotation/rotation_in_time.h"
#include "formula/language/evaluate.h"
#include "formula/language/which.h"
#include "formula/planar/solve_rotation.h"
#include "plane/query/moved.h"

namespace findspace::formula {

using distance::Sense;
using distance::ValueRange;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::RotationMap;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Real kAboutAnEnd = Real::ratio(1, 1000000000);  // degrees: more than an angle in doubles is off

constexpr double kBeyond = 1e-9;  // no sign: more than values are off

double way_of(const plane::RotationInterval& i) {
  const double d = i.to.degrees() - i.from.degrees();
  return d < 0 ? d + 360 : d;
}

bool is_exact(const RotationSolver::Bounds& set) {
  const RotationMap open = plane::overlay(std::array<const RotationMap*, 2>{&set.inner, &set.outer},
                                          [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
  return plane::intervals(open).empty();
}

}  // namespace

bool RotationSolver::rotations_twice(const Formula& formula) const {
  about_ = centre(formula);
  const auto& maps = formula.sign_maps();
  return std::any_of(maps.begin(), maps.end(), [&](const SignMap& m) { return rotations_twice(m); });
}

bool RotationSolver::rotations_twice(const Distance& distance) const {
  return rotations_twice(SignMap{distance, Real(1)});
}

distance::BoundedRotations RotationSolver::bounded_map(const SignMap& wanted) const {
  if (rotations_twice(wanted) && wanted.minimum) {
    const RotationMap all = RotationMap::uniform(1);
    const Best least = best(wanted.distance, {all, all}, distance::Sense::kMinimum);
    const auto there = plane::remark(least.possible, [](Mark m) { return Mark(m > 0 ? 0 : 1); });
    return {there, RotationMap::uniform(1)};
  }
  if (!rotations_twice(wanted)) {
    RotationMap exact = sign_map(wanted);
    return {exact, exact};
  }
  const exact::Real& step = solver_.world().step;
  const Distance d = moving_first(wanted.distance, solver_.world().moving);
  const plane::Region b = solver_.shape(d.first), a = solver_.shape(d.second);
  const RealPoint to{about_.x + pose_.at.x / step, about_.y + pose_.at.y / step};
  const RealPoint centre{d.vector.at(0) / step, d.vector.at(1) / step};
  return distance::rotation_angle_maps({b, a, about_, to}, solver_.which(d), centre, wanted.level);
}

distance::ValueRange RotationSolver::values_over(const Distance& wanted, const plane::RotationInterval& angles,
                                                 Sense sense) const {
  const RealPoint at{about_.x + pose_.at.x / solver_.world().step, about_.y + pose_.at.y / solver_.world().step};
  const Distance d = moving_first(wanted, solver_.world().moving);
  const double first = angles.from.degrees(), way = angles.round ? 360 : way_of(angles);
  const Real from = Real::from_double(first), to = Real::from_double(first + way);
  // The ends are known to rounding: a little of the circle about each stands for it.
  const std::vector<Real> stops{from - kAboutAnEnd, from + kAboutAnEnd, to - kAboutAnEnd, to + kAboutAnEnd};
  const auto over = [&](std::size_t first_stop, std::size_t last_stop) {
    std::vector<distance::RotatingPose> poses(2);
    poses[0].moving = stops[first_stop];
    poses[1].moving = stops[last_stop];
    return distance::RotationInTime(
        plane::moved(solver_.shape(d.first), {-about_.x, -about_.y}), solver_.shape(d.second), solver_.which(d),
        {d.vector.at(0) / solver_.world().step, d.vector.at(1) / solver_.world().step}, at, poses);
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

/// Rotated so that less is better.
ValueRange RotationSolver::values_twice(const Distance& d, const RotationMap& within, Sense sense) const {
  ValueRange all{kInfinity, kInfinity};
  for (const plane::RotationInterval& i : plane::intervals(within)) {
    const ValueRange v = values_over(d, i, sense);
    all = {std::min(all.low, v.low), std::min(all.high, v.high)};
  }
  return all;
}

RotationSolver::Best RotationSolver::best(const Distance& d, const Bounds& within, Sense sense) const {
  const int rotation = sense == Sense::kMinimum ? 1 : -1;
  Best out{std::nullopt, 0, false, RotationMap::uniform(0)};
  double value = kInfinity;
  if (rotations_twice(d)) {
    const ValueRange outer = values_twice(d, within.outer, sense);
    value = is_exact(within) ? outer.high : values_twice(d, within.inner, sense).high;
    out.bound = rotation * outer.low;
  } else {
    const auto exact = [&](const RotationMap& set) { return rotation > 0 ? least(d, set) : greatest(d, set); };
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
  const distance::BoundedRotations near = bounded_map({d, Real::from_double(rotation * value + rotation * kBeyond)});
  const RotationMap& bound = rotation > 0 ? near.low : near.high;
  out.possible = plane::overlay(std::array<const RotationMap*, 2>{&bound, &within.outer},
                                [rotation](std::span<const Mark> m) { return Mark(m[1] > 0 && rotation * m[0] <= 0); });
  return out;
}

AtomAt RotationSolver::check_least(const Atom& atom) const {
  const Distance& d = atom.distance;
  const bool rotating = d.mode == Mode::kRotation;
  AtomAt out{atom, rotating ? rotation_at(d, Real()).distance : rotated_solver().distance_at(d, pose_.at), false, {}};
  const RotationMap all = RotationMap::uniform(1);
  std::optional<double> least_value;  // not proven
  if (rotations_twice(d)) {
    least_value = best(d, {all, all}, Sense::kMinimum).value.value_or(-kInfinity);
  } else if (const plane::RotationLeast found = least(d, all); found.exists && found.proven) {
    out.holds = mark_at(found.at, exact::Angle::of_degrees(pose_.degrees)) > 0;
  } else if (found.exists) {
    least_value = found.value.to_double();
  }
  const auto& value = out.distance.value;
  if (least_value && value && *value <= *least_value + kBeyond * (1 + std::abs(*least_value)))
    refuse(d, "its least value over the angles is no whole number of steps; whether it is taken here is not decided");
  return out;
}

RotationSolver::Bounds RotationSolver::feasible_bounds(const Formula& formula) const {
  about_ = centre(formula);
  std::vector<distance::BoundedRotations> maps;
  for (const SignMap& m : formula.sign_maps()) maps.push_back(bounded_map(m));
  std::vector<const RotationMap*> operands;
  for (const auto& m : maps) operands.insert(operands.end(), {&m.low, &m.high});
  const RotationMap both =
      plane::overlay(operands, [&](std::span<const Mark> marks) { return certainty(formula, marks); });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

}  // namespace findspace::formula
