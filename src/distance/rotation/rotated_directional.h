// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances along a direction (directional.h) of a shape B that rotates about a point, as functions of the angle. What
// can be said of the points of B one by one is, with the map M of a single point, moved along the direction, against A
// at the level,
//   gamma1 > 0:          the least mark of M that B meets;
//   gamma2:              the least of M near the level, and the greatest of M beyond it;
//   eta1 < 0:            the greatest mark.
// gamma1 < 0, eta1 > 0 and eta2 depend on all of B at once: on the nearest (farthest) position along the direction that
// keeps B apart from A or in it (rotated_free.h). So do delta1 and delta2, with A rotated back in B and the direction
// with it. Guarantee: exact, as rotated_contact.h and rotated_free.h. Cost: one or three sweeps of A, or the level map
// of a point, then as those. Keywords: directional clearance, rotation.
#pragma once

#include "distance/planar/directional.h"
#include "distance/planar/shape_pair.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::distance {

/// B stands at { to + rotated(b - about) : b in B }.
struct RotatedShapes {
  const plane::Region& rotating;
  const plane::Region& fixed;
  exact::RealPoint about, to;
};

/// The sign of the distance minus the level at all angles. The level is not 0 but for gamma2, eta2 and delta2. `which`:
/// gamma, eta or delta.
plane::RotationMap rotated_directional(const RotatedShapes& shapes, Which which, const TranslationDirection& direction,
                                       const exact::Real& level);

}  // namespace findspace::distance
