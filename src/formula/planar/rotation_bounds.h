// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Angles where they are known between bounds only: distances in rotation about another point than the moving shape
// rotates about, at levels other than 0 (rotational_by_angle.h). Keywords: interval, orientation, branch and bound.
#pragma once

#include <optional>

#include "distance/planar_least/extremum.h"
#include "formula/planar/rotation_maps.h"

namespace findspace::formula {

/// Angles that certainly and that possibly belong.
struct RotationBounds {
  plane::RotationMap inner, outer;
};
RotationBounds rotation_bounds(const RotationMaps& maps, const Formula& formula);

/// Angles as far as they are known: exactly, or those that certainly belong and, in `outer`, the possible ones.
struct SolvedAngles {
  plane::RotationMap angles;
  std::optional<plane::RotationMap> outer;
};
SolvedAngles solve_angles(const RotationMaps& maps, const Formula& formula);

/// The least or greatest value over solved angles in the scene's unit, or in degrees, and the angles that take it.
using BestAngles = distance::OptimumOf<SolvedAngles>;
BestAngles best_angles(const RotationMaps& maps, const Distance& distance, const SolvedAngles& within,
                       distance::Sense sense);

}  // namespace findspace::formula
