// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bounds of the sign map of a rotational distance (rotational_distance.h) as a function of the position: how far the
// shape B + p has to turn about a fixed point until the answer changes. B + p rotated by an angle meets A where B + p
// meets A rotated back, so a level asks for the least or greatest plain distance while A rotates through a range of
// angles (rotational_levels.h). Guarantee: certified, low <= true sign <= high, as motion_maps.h. Level 0 needs none of
// this: it is the plain sign map, exactly. Cost: as motion_maps.h, twice for the second kind. Over the time of a motion
// the time is cut as well, where the order of the extrema does not allow to take whole legs. Source:
// distances.md 7.2, 7.3. Keywords: angular clearance map, swept area of a rotation.
#pragma once

#include "distance/rotation/motion_maps.h"

namespace findspace::distance {

/// `which`: kGamma1, kEta1, kDelta1 or the second kinds; `centre` in grid steps, the level in degrees. `step`: size of
/// a grid step, for the place of an error.
BoundedMaps rotation_position_maps(const plane::Region& b, const plane::Region& a, Which which,
                                   const exact::RealPoint& centre, const exact::Real& level, double step = 1);
/// Its inf or sup over a motion.
BoundedMaps rotation_position_maps(const plane::Region& b, const plane::Region& a, Which which,
                                   const exact::RealPoint& centre, const exact::Real& level,
                                   const std::vector<RotatingPose>& poses, Sense over_time, double step = 1);

}  // namespace findspace::distance
