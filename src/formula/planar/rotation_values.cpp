// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/rotation_values.h"

#include <algorithm>
#include <cmath>

#include "formula/planar/position_functions.h"

namespace findspace::formula {

using distance::RotatingMotion;
using distance::RotatingPose;
using distance::ValueRange;
using exact::Real;
using exact::RealPoint;

bool in_rotation(const SignMap& wanted) {
  return wanted.distance.mode == Mode::kRotation && (wanted.minimum || !is_plain_level(wanted));
}

bool is_bounded(const PreparedWorld& world, const Distance& wanted) {
  return wanted.mode == Mode::kRotation || world.roles(wanted).rotating;
}

bool rotations_in(const PreparedWorld& world, const Formula& formula) {
  const auto& maps = formula.sign_maps();
  return !world.world().instant && std::any_of(maps.begin(), maps.end(), [&](const SignMap& m) {
    return world.roles(m.distance).rotating || in_rotation(m);
  });
}

std::vector<RotatingPose> rotation_poses(const PreparedWorld& world, const Roles& r, bool instant) {
  const Motion& motion = world.motion();
  if (!motion.given()) return {RotatingPose{}};
  const Trajectory b = common_trajectory(motion, r.names.first), a = common_trajectory(motion, r.names.second);
  std::vector<RotatingPose> poses;
  for (const Real& t : instant ? std::vector{*world.world().instant} : common_times(motion, b, a)) {
    const RealPoint q = position_at(a, t), o = position_at(b, t);
    poses.push_back({{o.x - q.x, o.y - q.y}, angle_at(b, t), angle_at(a, t), q});
  }
  return poses;
}

distance::RotationInTime rotation_in_time(const PreparedWorld& world, const Roles& r, const RealPoint& p,
                                          bool instant) {
  return {world.shape(r.names.first),
          world.shape(r.names.second),
          r.which(),
          world.steps({r.wanted.vector.at(0), r.wanted.vector.at(1)}),
          p,
          rotation_poses(world, r, instant),
          world.step().to_double()};
}

RotatingMotion rotation_motion(const PreparedWorld& world, const Roles& r, bool instant) {
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "only distances in all directions are computed of shapes that rotate in time");
  // Made outside: the world is asked for its shapes.
  const auto make = [shapes = std::pair(world.shape(r.names.first), world.shape(r.names.second)),
                     poses = rotation_poses(world, r, instant), step = world.step().to_double()] {
    return std::make_shared<const distance::TurningShapes>(shapes.first, shapes.second, poses, step);
  };
  return {instant ? make() : world.turning(r.names, make), r.which()};
}

std::optional<ValueRange> rotation_value(const PreparedWorld& world, const Roles& r, const RealPoint& p) {
  const bool one = world.world().instant && r.wanted.prefix == Extremum::kNone;
  const distance::Sense sense = sense_over_time(r.wanted);
  if (r.wanted.mode == Mode::kRotation) {
    const ValueRange v = rotation_in_time(world, r, p, one).extremum(sense);
    const bool undefined = std::isinf(v.low) && v.low > 0;
    return undefined ? std::nullopt : std::optional(v);
  }
  const RotatingMotion f = rotation_motion(world, r, one);
  return one ? f.instant(p, 0, Real()) : f.extremum(p, sense, 0, RotatingMotion::Effort::kFine);
}

double shown_value(const PreparedWorld& world, const ValueRange& v, const Roles& r) {
  const World& scene = world.world();
  const bool instant = !scene.motion.given() || (scene.instant && r.wanted.prefix == Extremum::kNone);
  if (std::isinf(v.low) || std::isinf(v.high)) return std::isinf(v.low) ? v.high : v.low;
  if (instant) return v.middle();
  return sense_over_time(r.wanted) == distance::Sense::kMinimum ? v.high : v.low;
}

}  // namespace findspace::formula
