// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rotational distances: how far B has to turn about a point until the answer changes (distances.md 7.2). From the map
// that carries - on O, 0 on C \ O, + elsewhere on the circle (gamma: interiors meet, shapes meet; eta: B in int A, in
// A; delta exchanged):
//   gamma1, eta1, delta1:  f = -(distance to the angles outside O) in O, 0 in C \ O, the distance to C elsewhere;
//   gamma2, eta2, delta2:  the greatest distance to an angle of C.
// Distances are measured along the circle, in degrees, at most 180. +infinity where C is empty; -infinity where O is
// everything. Guarantee: sign maps exact, their ends the contact angles plus or minus the level; values correct to
// about 1e-13. Keywords: angular clearance, rotation to contact.
#pragma once

#include "plane/rotation/rotation_map.h"

namespace findspace::distance {

/// The first kind at an angle; may be infinite. `base` carries -, 0, +.
double rotation_distance(const plane::RotationMap& base, const exact::Angle& at);
/// The sign of it minus a level (degrees), at all angles.
plane::RotationMap rotation_sign_map(const plane::RotationMap& base, const exact::Real& level);

/// The second kind: 180 minus the distance of the opposite angle to C.
double farthest_rotation(const plane::RotationMap& base, const exact::Angle& at);
plane::RotationMap farthest_rotation_sign_map(const plane::RotationMap& base, const exact::Real& level);

}  // namespace findspace::distance
