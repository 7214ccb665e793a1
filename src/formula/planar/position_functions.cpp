// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/position_functions.h"

#include "distance/planar/at_position.h"
#include "distance/planar/directional.h"
#include "distance/rotation/over_time.h"

namespace findspace::formula {

using distance::PositionFunctionPointer;
using distance::SignedDistance;
using distance::TDistancePointer;
using distance::Which;

namespace {

TDistancePointer plain_distance(const PreparedWorld& world, const Roles& r) {
  return world.pair(r.names)->pair().distance(r.which());
}

/// gamma1 for gamma2, eta1 for eta2, delta1 for delta2: where the base map is.
Which signed_base(Kind kind) {
  const bool gamma = kind == Kind::kGamma1 || kind == Kind::kGamma2;
  const bool eta = kind == Kind::kEta1 || kind == Kind::kEta2;
  return gamma ? Which::kGamma1 : eta ? Which::kEta1 : Which::kDelta1;
}

}  // namespace

std::shared_ptr<const SignedDistance> directional_base(const PreparedWorld& world, const Roles& r) {
  return std::static_pointer_cast<const SignedDistance>(
      world.pair(r.names)->pair().distance(signed_base(r.wanted.kind)));
}

namespace {

std::optional<exact::Refusal> rotation_refused(const Distance& d) {
  if (d.mode != Mode::kRotation) return std::nullopt;
  return refused(d, "distances in rotation are known between bounds only, and have no exact region here");
}

}  // namespace

std::optional<exact::Refusal> between_bounds(const PreparedWorld& world, const Distance& wanted) {
  const Roles r = world.roles(wanted);
  if (r.rotating) return refused(wanted, "shapes that rotate in time have no exact region here");
  return rotation_refused(r.wanted);
}

PositionFunctionPointer function_at_rest(const PreparedWorld& world, const Roles& r) {
  const Distance& d = r.wanted;
  if (d.mode == Mode::kPlain) return plain_distance(world, r);
  if (const auto why = rotation_refused(d)) throw why->error;
  const plane::SignMap& map = directional_base(world, r)->base();
  if (is_farthest(d.kind)) return std::make_shared<distance::DirectionalFarthest>(map, direction(d));
  return std::make_shared<distance::DirectionalSigned>(map, direction(d));
}

PositionFunctionPointer position_function(const PreparedWorld& world, const Distance& wanted) {
  if (const auto why = between_bounds(world, wanted)) throw why->error;
  const Roles r = world.roles(wanted);
  const World& scene = world.world();
  if (!scene.motion.given()) return function_at_rest(world, r);
  if (scene.instant && wanted.prefix == Extremum::kNone)
    return distance::at_instant(function_at_rest(world, r), position_at(r.path, *scene.instant));
  if (r.wanted.mode != Mode::kPlain)
    return distance::jumping_over_time(function_at_rest(world, r), r.path.path, sense_over_time(r.wanted));
  return over_its_time(world, wanted, plain_distance(world, r));
}

PositionFunctionPointer over_its_time(const PreparedWorld& world, const Distance& wanted, TDistancePointer of_pair) {
  if (!world.motion().given()) return of_pair;
  const Roles r = world.roles(wanted);
  return distance::over_time(std::move(of_pair), r.path.path, sense_over_time(r.wanted));
}

distance::Sense sense_over_time(const Distance& d) {
  return natural_extremum(d) == Extremum::kInf ? distance::Sense::kMinimum : distance::Sense::kMaximum;
}

std::vector<exact::RealPoint> way(const PreparedWorld& world, const Distance& wanted) {
  if (!world.motion().given()) return {exact::RealPoint{}};
  return world.roles(wanted).path.path;
}

TDistancePointer searched_distance(const PreparedWorld& world, const Roles& r) {
  return world.pair(r.names)->pair().searched(r.which());
}

TDistancePointer objective_distance(const PreparedWorld& world, const Distance& wanted) {
  if (wanted.mode != Mode::kPlain) refuse(wanted, "distances along a direction or in rotation are not objectives");
  if (world.motion().given())
    refuse(wanted, "the least and greatest values over positions are not computed with a motion");
  return searched_distance(world, world.roles(wanted));
}

}  // namespace findspace::formula
