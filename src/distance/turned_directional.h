// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances along a direction (directional.h) of a shape B that turns about a point, as functions of the angle, where
// they can be said of the points of B one by one: with the map M of a single point, moved along the direction, against
// A at the level,
//   gamma1 > 0:          the least mark of M that B meets;
//   gamma2:              the least of M near the level, and the greatest of M beyond it;
//   eta1 < 0:            the greatest mark.
// Guarantee: exact, as turned_contact.h. Cost: one or three sweeps of A, then as turned_contact.h. Keywords:
// directional clearance, rotation.
#pragma once

#include <optional>

#include "distance/directional.h"
#include "distance/shape_pair.h"
#include "plane/turn_map.h"

namespace findspace::distance {

/// B stands at { to + turned(b - about) : b in B }.
struct TurnedShapes {
  const plane::Region& turning;
  const plane::Region& fixed;
  exact::RealPoint about, to;
};

/// The sign of the distance minus the level, which is not 0 for gamma1 and eta1, at all angles. Nothing where all of B
/// counts at once: gamma1 < 0, eta1 > 0, eta2, and delta, whose direction turns with B.
std::optional<plane::TurnMap> turned_directional(const TurnedShapes& shapes, Which which, const Track& track,
                                                 const exact::Real& level);

}  // namespace findspace::distance
