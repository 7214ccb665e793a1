// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solver where regions are known between bounds only: shapes that turn in time, and distances in rotation at levels
// other than 0.

#include <algorithm>
#include <cmath>

#include "distance/rotation/rotation_positions.h"
#include "formula/language/evaluate.h"
#include "formula/language/which.h"
#include "formula/planar/solve.h"
#include "plane/complex/overlay.h"

namespace findspace::formula {

using distance::Which;
using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;

distance::Sense Solver::sense_over_time(const Distance& d) {
  return natural_extremum(d) == Extremum::kInf ? distance::Sense::kMinimum : distance::Sense::kMaximum;
}

std::vector<distance::RotatingPose> Solver::rotation_poses(const Roles& r, bool instant) const {
  const Motion& motion = world_.motion;
  if (!motion.given()) return {distance::RotatingPose{}};
  const Trajectory b = common_trajectory(motion, r.names.first), a = common_trajectory(motion, r.names.second);
  std::vector<distance::RotatingPose> poses;
  for (const Real& t : instant ? std::vector{*world_.instant} : common_times(motion, b, a)) {
    const RealPoint q = position_at(a, t), o = position_at(b, t);
    poses.push_back({{o.x - q.x, o.y - q.y}, angle_at(b, t), angle_at(a, t), q});
  }
  return poses;
}

bool Solver::rotations_in(const Formula& formula) const {
  const auto& maps = formula.sign_maps();
  return !world_.instant && std::any_of(maps.begin(), maps.end(),
                                        [&](const SignMap& m) { return roles(m.distance).rotating || in_rotation(m); });
}

bool Solver::in_rotation(const SignMap& wanted) const {
  return wanted.distance.mode == Mode::kRotation && (wanted.minimum || !is_plain_level(wanted));
}

distance::RotationInTime Solver::rotation_in_time(const Roles& r, const RealPoint& p, bool instant) const {
  return {shape(r.names.first),
          shape(r.names.second),
          formula::which(r.wanted.kind, r.second_moves),
          steps({r.wanted.vector.at(0), r.wanted.vector.at(1)}),
          p,
          rotation_poses(r, instant)};
}

distance::RotatingMotion Solver::rotation_motion(const Roles& r, bool instant) const {
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "only distances in all directions are computed of shapes that turn in time");
  return {shape(r.names.first), shape(r.names.second), formula::which(r.wanted.kind, r.second_moves),
          rotation_poses(r, instant)};
}

distance::BoundedMaps Solver::bounded_maps(const SignMap& asked) const {
  const SignMap wanted = plain_level(asked);
  const Roles r = roles(wanted.distance);
  if (!r.rotating && !in_rotation(wanted)) {
    plane::SignMap exact = sign_map(wanted);
    return {exact, exact};
  }
  if (wanted.minimum) return bounded_minimisers(wanted);
  const distance::Sense sense = sense_over_time(r.wanted);
  if (in_rotation(wanted)) {
    const RealPoint centre = steps({r.wanted.vector.at(0), r.wanted.vector.at(1)});
    const Which kind = formula::which(r.wanted.kind, r.second_moves);
    const plane::Region b = shape(r.names.first), a = shape(r.names.second);
    if (!world_.motion.given()) return distance::rotation_position_maps(b, a, kind, centre, wanted.level);
    return distance::rotation_position_maps(b, a, kind, centre, wanted.level, rotation_poses(r, false), sense);
  }
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "only distances in all directions are computed of shapes that turn in time");
  Which kind = formula::which(r.wanted.kind, r.second_moves);
  // Containment down from level 0 is the directed Hausdorff distance, which changes no faster than the shapes do.
  if ((kind == Which::kEta1 || kind == Which::kDelta1) && wanted.level.sign() <= 0)
    kind = kind == Which::kEta1 ? Which::kMu : Which::kMuBack;
  const auto bounds = [&](Which of, const Real& level) {
    return distance::rotation_maps(shape(r.names.first), shape(r.names.second), of, rotation_poses(r, false), sense,
                                   level / world_.step);
  };
  const bool eta = kind == Which::kEta1 || kind == Which::kEta2, first = kind == Which::kEta1 || kind == Which::kDelta1;
  if (!eta && !first && kind != Which::kDelta2) return bounds(kind, wanted.level);
  // The places where a shape fits come and go with its angle. But eta is at least mu, and eta1 not above 0 where mu is
  // not.
  const Which mu = eta ? Which::kMu : Which::kMuBack;
  distance::BoundedMaps out{bounds(mu, wanted.level).low, plane::SignMap::uniform(1)};
  if (first) out.high = plane::remark(bounds(mu, Real()).high, [](Mark k) { return Mark(k <= 0 ? -1 : 1); });
  return out;
}

Solver::Bounds Solver::feasible_bounds(const Formula& formula) const {
  const std::size_t n = formula.sign_maps().size();
  std::vector<distance::BoundedMaps> maps(n);
  for (std::size_t k = 0; k < n; ++k) maps[k] = bounded_maps(formula.sign_maps()[k]);
  std::vector<const CellComplex*> operands;
  for (const auto& m : maps) operands.insert(operands.end(), {&m.low, &m.high});
  // 2 where every choice of signs between the bounds satisfies the formula, 1 where some does.
  const CellComplex both =
      plane::overlay(operands, [&](std::span<const Mark> marks) { return certainty(formula, marks); });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

std::optional<distance::ValueRange> Solver::rotation_value(const Roles& r, const RealPoint& p) const {
  const bool one = world_.instant && r.wanted.prefix == Extremum::kNone;
  const distance::Sense sense = sense_over_time(r.wanted);
  if (r.wanted.mode == Mode::kRotation) {
    const distance::ValueRange v = rotation_in_time(r, p, one).extremum(sense);
    const bool undefined = std::isinf(v.low) && v.low > 0;
    return undefined ? std::nullopt : std::optional(v);
  }
  const distance::RotatingMotion f = rotation_motion(r, one);
  return one ? f.instant(p, 0, Real()) : f.extremum(p, sense, 0, distance::RotatingMotion::Effort::kFine);
}

}  // namespace findspace::formula
