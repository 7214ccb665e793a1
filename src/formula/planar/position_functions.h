// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The functions of positions that the distances of a formula mean, in grid steps: of a pair of shapes, along a
// direction, over the time of a motion or at an instant of it. Guarantee: exact; Error(kUnsupported) for those that are
// known between bounds only (rotation_values.h). Keywords: distance field, level set.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "distance/planar/shape_pair.h"
#include "distance/planar/signed_distance.h"
#include "formula/planar/prepared_world.h"

namespace findspace::formula {

/// Why a distance is known between bounds only, if it is.
std::optional<exact::Refusal> between_bounds(const PreparedWorld& world, const Distance& wanted);
/// The function that a distance means, over time or at the world's instant too.
distance::PositionFunctionPointer position_function(const PreparedWorld& world, const Distance& wanted);
/// The same without the motion.
distance::PositionFunctionPointer function_at_rest(const PreparedWorld& world, const Roles& roles);
/// A distance of a pair as a formula means `wanted`: over the time of a motion.
distance::PositionFunctionPointer over_its_time(const PreparedWorld& world, const Distance& wanted,
                                                distance::TDistancePointer of_pair);

/// Which extremum over the time of a motion a distance means.
distance::Sense sense_over_time(const Distance& wanted);
/// Of a motion of shapes that do not turn, the places of the first of a pair as seen from the second; else the origin.
std::vector<exact::RealPoint> way(const PreparedWorld& world, const Distance& wanted);

/// The T-distance of the pair, its shapes moved to where numbers are small: for searches of extrema.
distance::TDistancePointer searched_distance(const PreparedWorld& world, const Roles& roles);
/// The same of an objective. Throws Error(kUnsupported) for distances that are no T-distances.
distance::TDistancePointer objective_distance(const PreparedWorld& world, const Distance& wanted);
/// What a distance along a direction is measured in: gamma1, eta1 or delta1 of the pair.
std::shared_ptr<const distance::SignedDistance> directional_base(const PreparedWorld& world, const Roles& roles);

}  // namespace findspace::formula
