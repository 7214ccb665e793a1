// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/nearest_feasible.h"

#include "distance/planar/at_position.h"
#include "formula/language/nearest_contact.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/position_check.h"
#include "formula/planar/regions.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using distance::Coordinates;
using exact::Real;
using exact::RealPoint;
using plane::Mark;

namespace {

NearestFeasible nearest_in_scene(const PreparedWorld& world, const plane::Nearest& n, bool attained) {
  return {distance::coordinates(distance::times(world.step(), n.at)), n.distance * world.step(), attained};
}

std::optional<NearestFeasible> from_contacts(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  if (world.motion().given()) return std::nullopt;
  const auto steps = [&](const Coordinates& q) { return world.steps({q[0], q[1]}); };
  const ContactWorld asked{[&](const Distance& d, const Coordinates& q) -> std::optional<distance::SceneAnswer> {
                             const Roles r = world.roles(d);
                             if (r.rotating) return std::nullopt;
                             const auto m = world.pair(r.names)->measure(r.which(), steps(q));
                             return m ? std::optional(distance::in_scene(*m, world.step())) : std::nullopt;
                           },
                           [&](std::size_t atom, const Coordinates& q) -> std::optional<int> {
                             return sign_at(world, formula.sign_maps()[formula.sign_map_of(atom)], steps(q));
                           }};
  return nearest_by_contact(asked, formula, distance::coordinates(distance::times(world.step(), p)));
}

}  // namespace

TriedNearest nearest_feasible_to(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  if (auto near = from_contacts(world, formula, p)) return near;
  if (const auto why = between_bounds(world, formula)) return *why;
  if (const auto near = nearest_in_windows(world, formula, p))
    return nearest_in_scene(world, near->nearest, near->attained);
  plane::Region region = feasible(world, formula), closed = plane::closure(region);
  auto in = [](Mark m) { return m > 0; };
  auto here = mark_of(closed, locate(closed, p)) > 0;
  auto n = here ? std::optional(plane::Nearest{Real(), p, {}}) : plane::nearest(closed, in, p);
  if (!n) return std::nullopt;
  return nearest_in_scene(world, *n, mark_of(region, locate(region, n->at)) > 0);
}

}  // namespace findspace::formula
