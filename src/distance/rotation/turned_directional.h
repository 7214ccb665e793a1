// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances along a direction (directional.h) of a shape B that turns about a point, as functions of the angle. What
// can be said of the points of B one by one is, with the map M of a single point, moved along the direction, against A
// at the level,
//   gamma1 > 0:          the least mark of M that B meets;
//   gamma2:              the least of M near the level, and the greatest of M beyond it;
//   eta1 < 0:            the greatest mark.
// gamma1 < 0, eta1 > 0 and eta2 depend on all of B at once: on the nearest (farthest) position along the direction that
// keeps B apart from A or in it (turned_free.h). So do delta1 and delta2, with A turned back in B and the direction
// with it. Guarantee: exact, as turned_contact.h and turned_free.h. Cost: one or three sweeps of A, or the level map of
// a point, then as those. Keywords: directional clearance, rotation.
#pragma once

#include "distance/planar/directional.h"
#include "distance/planar/shape_pair.h"
#include "plane/rotation/turn_map.h"

namespace findspace::distance {

/// B stands at { to + turned(b - about) : b in B }.
struct TurnedShapes {
  const plane::Region& turning;
  const plane::Region& fixed;
  exact::RealPoint about, to;
};

/// The sign of the distance minus the level at all angles. The level is not 0 but for gamma2, eta2 and delta2. `which`:
/// gamma, eta or delta.
plane::TurnMap turned_directional(const TurnedShapes& shapes, Which which, const Track& track,
                                  const exact::Real& level);

}  // namespace findspace::distance
