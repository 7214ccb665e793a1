// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bounds of the sign map of extrema of a distance f between shapes that are translated and turn, over time and over
// turns. Both are cut into short pieces; in each the shapes stand rotated by the middle angle, which changes f by at
// most r = half the piece's angle in radians times the shapes' reach (plus what rounding moved), and the translation
// is exact:
//     low  = sign of a function <= the extremum minus the level,   high = sign of one >= it.
// Guarantee: certified, low <= true sign <= high everywhere; for distances that change no faster than their shapes
// (gamma2, mu, hausdorff, d, h, diameter), and gamma1 and penetration, by rated_gap.h where they do not. Cost: two sign
// maps and sweeps for each piece, one overlay of all. Source: distances.md 3.7, 7.3. Keywords: interval bound,
// conservative, inner and outer approximation.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "distance/rotation/rotation_motion.h"
#include "distance/rotation/rotational_levels.h"

namespace findspace::distance {

/// A short time, and a choice of turns.
struct RotatingPiece {
  std::array<exact::RealPoint, 2> way;  // of B as seen from A, in grid steps
  exact::Real moving, fixed;            // angles in the middle, in degrees
  double in_time = 0;                   // by how much f may differ as the angles go on in time, in grid steps
  double over_rotations = 0;            // and over the turns that the piece stands for
};

/// Which extremum is meant.
struct RotationSenses {
  Sense pieces;     // over pieces, and over the turns of each
  Sense low, high;  // along the way of a piece, for either bound
};

/// `step`: size of a grid step, for the place of an error.
BoundedMaps motion_maps(const plane::Region& b, const plane::Region& a, Which which,
                        std::span<const RotatingPiece> pieces, const RotationSenses& senses, const exact::Real& level,
                        double step = 1);

/// inf or sup over the time of a motion; `poses` as for RotatingMotion, `level` in grid steps.
BoundedMaps motion_maps(const plane::Region& b, const plane::Region& a, Which which,
                        const std::vector<RotatingPose>& poses, Sense sense, const exact::Real& level, double step = 1);

/// Into how many pieces a leg is cut whose angles change by so much.
int pieces_of_leg(const RotatingPose& from, const RotatingPose& to);

}  // namespace findspace::distance
