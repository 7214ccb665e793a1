// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bounds of the sign map of inf or sup over time of a distance f between shapes that are translated and turn. The time
// is cut into short pieces; in each the shapes stand turned by the middle angle, which changes f by at most r = half
// the piece's angle in radians times the shapes' reach (plus what rounding moved), and the translation is exact:
//     low  = sign of a function <= inf f (sup f) minus the level,   high = sign of one >= it.
// Guarantee: certified, low <= true sign <= high everywhere; for distances that change no faster than their shapes
// (gamma, mu, hausdorff, d, h, diameter, penetration). Cost: two sign maps and sweeps for each piece, one overlay of
// all. Source: distances.md 3.7, 7.3. Keywords: interval bound, conservative, inner and outer approximation.
#pragma once

#include <vector>

#include "distance/turning_levels.h"
#include "distance/turning_motion.h"

namespace findspace::distance {

/// `poses` as for TurningMotion, `level` in grid steps.
BoundedMaps turning_maps(const plane::Region& b, const plane::Region& a, Which which,
                         const std::vector<TurningPose>& poses, Sense sense, const exact::Real& level);

}  // namespace findspace::distance
