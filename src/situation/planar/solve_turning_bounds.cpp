// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// TurnSolver where angles are known between bounds only: distances in rotation about another point than the moving
// shape turns about, at levels other than 0 (turning_angles.h).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/turning_angles.h"
#include "plane/query/moved.h"
#include "situation/formula/evaluate.h"
#include "situation/formula/which.h"
#include "situation/planar/solve_turning.h"

namespace findspace::situation {

using distance::Sense;
using distance::ValueRange;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::TurnMap;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Real kAboutAnEnd = Real::ratio(1, 1000000000);  // degrees: more than an angle in doubles is off

constexpr double kBeyond = 1e-9;  // no sign: more than values are off

double way_of(const plane::TurnInterval& i) {
  const double d = i.to.degrees() - i.from.degrees();
  return d < 0 ? d + 360 : d;
}

bool is_exact(const TurnSolver::Bounds& set) {
  const TurnMap open = plane::overlay(std::array<const TurnMap*, 2>{&set.inner, &set.outer},
                                      [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
  return plane::intervals(open).empty();
}

}  // namespace

bool TurnSolver::turns_twice(const Formula& formula) const {
  about_ = centre(formula);
  const auto& maps = formula.sign_maps();
  return std::any_of(maps.begin(), maps.end(), [&](const SignMap& m) { return turns_twice(m); });
}

bool TurnSolver::turns_twice(const Distance& distance) const { return turns_twice(SignMap{distance, Real(1)}); }

distance::BoundedTurns TurnSolver::bounded_map(const SignMap& wanted) const {
  if (turns_twice(wanted) && wanted.minimum) {
    const TurnMap all = TurnMap::uniform(1);
    const Best least = best(wanted.distance, {all, all}, distance::Sense::kMinimum);
    const auto there = plane::remark(least.possible, [](Mark m) { return Mark(m > 0 ? 0 : 1); });
    return {there, TurnMap::uniform(1)};
  }
  if (!turns_twice(wanted)) {
    TurnMap exact = sign_map(wanted);
    return {exact, exact};
  }
  const exact::Real& step = solver_.world().step;
  const Distance d = moving_first(wanted.distance, solver_.world().moving);
  const plane::Region b = solver_.shape(d.first), a = solver_.shape(d.second);
  const RealPoint to{about_.x + pose_.at.x / step, about_.y + pose_.at.y / step};
  const RealPoint centre{d.vector.at(0) / step, d.vector.at(1) / step};
  return distance::turning_angle_maps({b, a, about_, to}, solver_.which(d), centre, wanted.level);
}

distance::ValueRange TurnSolver::values_over(const Distance& wanted, const plane::TurnInterval& angles,
                                             Sense sense) const {
  const RealPoint at{about_.x + pose_.at.x / solver_.world().step, about_.y + pose_.at.y / solver_.world().step};
  const Distance d = moving_first(wanted, solver_.world().moving);
  const double first = angles.from.degrees(), way = angles.round ? 360 : way_of(angles);
  const Real from = Real::from_double(first), to = Real::from_double(first + way);
  // The ends are known to rounding: a little of the circle about each stands for it.
  const std::vector<Real> stops{from - kAboutAnEnd, from + kAboutAnEnd, to - kAboutAnEnd, to + kAboutAnEnd};
  const auto over = [&](std::size_t first_stop, std::size_t last_stop) {
    std::vector<distance::TurningPose> poses(2);
    poses[0].moving = stops[first_stop], poses[1].moving = stops[last_stop];
    return distance::RotationInTime(
        plane::moved(solver_.shape(d.first), {-about_.x, -about_.y}), solver_.shape(d.second), solver_.which(d),
        {d.vector.at(0) / solver_.world().step, d.vector.at(1) / solver_.world().step}, at, poses);
  };
  const int turn = sense == Sense::kMinimum ? 1 : -1;
  const auto better = [turn](ValueRange v) { return turn > 0 ? v : ValueRange{-v.high, -v.low}; };
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

/// Turned so that less is better.
ValueRange TurnSolver::values_twice(const Distance& d, const TurnMap& within, Sense sense) const {
  ValueRange all{kInfinity, kInfinity};
  for (const plane::TurnInterval& i : plane::intervals(within)) {
    const ValueRange v = values_over(d, i, sense);
    all = {std::min(all.low, v.low), std::min(all.high, v.high)};
  }
  return all;
}

TurnSolver::Best TurnSolver::best(const Distance& d, const Bounds& within, Sense sense) const {
  const int turn = sense == Sense::kMinimum ? 1 : -1;
  Best out{std::nullopt, 0, false, TurnMap::uniform(0)};
  double value = kInfinity;
  if (turns_twice(d)) {
    const ValueRange outer = values_twice(d, within.outer, sense);
    value = is_exact(within) ? outer.high : values_twice(d, within.inner, sense).high;
    out.bound = turn * outer.low;
  } else {
    const auto exact = [&](const TurnMap& set) { return turn > 0 ? least(d, set) : greatest(d, set); };
    const plane::TurnLeast inner = exact(within.inner), outer = exact(within.outer);
    if (inner.exists) value = turn * inner.value.to_double();
    out.bound = outer.exists ? outer.value.to_double() : turn * kInfinity;
  }
  if (std::isinf(value)) {
    out.none = value < 0 || turn * out.bound == kInfinity;
    out.possible = within.outer;
    return out;
  }
  out.value = turn * value;
  const distance::BoundedTurns near = bounded_map({d, Real::from_double(turn * value + turn * kBeyond)});
  const TurnMap& bound = turn > 0 ? near.low : near.high;
  out.possible = plane::overlay(std::array<const TurnMap*, 2>{&bound, &within.outer},
                                [turn](std::span<const Mark> m) { return Mark(m[1] > 0 && turn * m[0] <= 0); });
  return out;
}

AtomAt TurnSolver::check_least(const Atom& atom) const {
  const Distance& d = atom.distance;
  const bool turning = d.mode == Mode::kTurning;
  AtomAt out{atom, turning ? turning_at(d, Real()).distance : turned_solver().distance_at(d, pose_.at), false, {}};
  const TurnMap all = TurnMap::uniform(1);
  std::optional<double> least_value;  // not proven
  if (turns_twice(d)) {
    least_value = best(d, {all, all}, Sense::kMinimum).value.value_or(-kInfinity);
  } else if (const plane::TurnLeast found = least(d, all); found.exists && found.proven) {
    out.holds = mark_at(found.at, exact::Angle::of_degrees(pose_.degrees)) > 0;
  } else if (found.exists) {
    least_value = found.value.to_double();
  }
  const auto& value = out.distance.value;
  if (least_value && value && *value <= *least_value + kBeyond * (1 + std::abs(*least_value)))
    refuse(d, "its least value over the angles is no whole number of steps; whether it is taken here is not decided");
  return out;
}

TurnSolver::Bounds TurnSolver::feasible_bounds(const Formula& formula) const {
  about_ = centre(formula);
  std::vector<distance::BoundedTurns> maps;
  for (const SignMap& m : formula.sign_maps()) maps.push_back(bounded_map(m));
  std::vector<const TurnMap*> operands;
  for (const auto& m : maps) operands.insert(operands.end(), {&m.low, &m.high});
  const TurnMap both = plane::overlay(operands, [&](std::span<const Mark> marks) { return certainty(formula, marks); });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

}  // namespace findspace::situation
