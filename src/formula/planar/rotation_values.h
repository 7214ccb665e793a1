// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values of distances that are known between bounds only: of shapes that rotate in time, and in rotation at levels
// other than 0. Positions in grid steps. Keywords: interval, rotational sweep.
#pragma once

#include <optional>
#include <vector>

#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/rotation_motion.h"
#include "formula/planar/prepared_world.h"

namespace findspace::formula {

/// In rotation, where that is not the plain distance.
bool in_rotation(const SignMap& wanted);
/// Only bounds of its values over positions are known: it is in rotation, or a shape rotates in time.
bool is_bounded(const PreparedWorld& world, const Distance& wanted);
/// Some shape of the formula rotates in time, and no instant is asked for, or some distance is one in rotation with a
/// level other than 0: feasible() is refused, feasible_bounds() is not.
bool rotations_in(const PreparedWorld& world, const Formula& formula);

/// Where the shapes of a distance are at the times that matter, or at the world's instant.
std::vector<distance::RotatingPose> rotation_poses(const PreparedWorld& world, const Roles& roles, bool instant);
/// Of a distance in rotation.
distance::RotationInTime rotation_in_time(const PreparedWorld& world, const Roles& roles, const exact::RealPoint& p,
                                          bool instant);
/// Of a plain distance of shapes that rotate in time.
distance::RotatingMotion rotation_motion(const PreparedWorld& world, const Roles& roles, bool instant);

/// In grid steps, of distances in rotation in degrees; nothing where undefined.
std::optional<distance::ValueRange> rotation_value(const PreparedWorld& world, const Roles& roles,
                                                   const exact::RealPoint& p);
/// The number of such a range that is shown: of an extremum over time the end that the distance is known to take.
double shown_value(const PreparedWorld& world, const distance::ValueRange& value, const Roles& roles);

}  // namespace findspace::formula
