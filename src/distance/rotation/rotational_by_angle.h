// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bounds of the sign of a rotational distance (rotational_distance.h) of a shape that itself stands rotated, as a
// function of that angle: B is rotated by the angle about one point, and how far it then has to turn about another, the
// centre, is measured. (About one and the same point the two turns add up, and rotation_sign_map is exact.)
//
// Method: rotating B about the centre is rotating A back, so a level asks for the least or greatest plain distance over
// a range of turns of A (rotational_levels.h). The range is cut into pieces; in each A stands rotated by the middle
// angle, which changes distances by at most r = half the piece in radians times A's reach from the centre, plus what
// rounding moved: the exact map over the angles of B at the levels -r and r bounds the piece. Pieces that leave angles
// open are halved. Guarantee: certified, low <= true sign <= high. Cost: up to 150 maps as rotated_pair.h. Keywords:
// angular clearance, double rotation.
#pragma once

#include "distance/rotation/rotated_directional.h"
#include "distance/rotation/rotational_levels.h"

namespace findspace::distance {

/// `which`: gamma, eta or delta; `centre` in grid steps, the level in degrees. `step`: size of a grid step, for the
/// place of an error.
BoundedRotations rotation_angle_maps(const RotatedShapes& shapes, Which which, const exact::RealPoint& centre,
                                     const exact::Real& level, double step = 1);

}  // namespace findspace::distance
