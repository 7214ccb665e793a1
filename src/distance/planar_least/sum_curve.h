// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a sum of elementary distances (to points, lines, circles) equals a level, if that is a line with a direction in
// integers, a circle, or nowhere: private to sum_map.h. Guarantee: exact. Cost: microseconds. Keywords: bisector,
// Apollonius circle.
#pragma once

#include <optional>
#include <span>

#include "distance/planar_least/distance_sum.h"
#include "plane/complex/broad_phase.h"

namespace findspace::distance {

/// Of each summand the form that it is.
std::optional<plane::SignMap> sign_of_forms(std::span<const Summand> summands, std::span<const LevelCurve> curves,
                                            const exact::Real& level, const plane::PieceBox& box);

/// The box as a closed region; its corners are on the grid.
plane::Region filled_box(const plane::PieceBox& box);

}  // namespace findspace::distance
