// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value of a function f of the angle over a set of angles, from its sign maps at levels. Guarantee: the
// bisection encloses the value to about 1e-13 of its size; where it is a whole number of steps, that is proven by the
// sign map there, and the angles are exact. Else the angles, one for each place, are given to about half the digits.
// Where f is -infinity, that is told, with all such angles. Cost: about 60 sign maps. Keywords: argmin over
// orientations.
#pragma once

#include <functional>

#include "distance/answer/optimum.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::distance {

/// Marks 1 at the angles.
using RotationOptimum = OptimumOf<plane::RotationMap>;

/// `sign(level)`: marks of f minus the level; `step`: f tends to be a multiple of it. The set has marks 0/1. Where f
/// `jumps`, a value at an end that the set lacks may be less than all near it.
RotationOptimum least_rotation(const std::function<plane::RotationMap(const exact::Real&)>& sign,
                               const plane::RotationMap& set, const exact::Real& step, bool jumps);

}  // namespace findspace::distance
