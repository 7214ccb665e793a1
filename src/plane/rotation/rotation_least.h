// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value of a function f of the angle over a set of angles, from its sign maps at levels. Guarantee: the
// bisection brackets the value to about 1e-13 of its size; where it is a whole number of steps, that is proven by the
// sign map there, and the angles are exact (`proven`). Else the value is given to that precision and the angles, one
// for each place, to about half the digits. Cost: about 60 sign maps. Keywords: argmin over orientations.
#pragma once

#include "plane/rotation/rotation_map.h"

namespace findspace::plane {

struct RotationLeast {
  bool exists = false;  // f has a least value on the closure of the set
  exact::Real value;
  bool attained = false;  // by an angle of the set
  bool proven = false;
  RotationMap at = RotationMap::uniform(0);  // 1 at the angles: of the set, or of its closure if not attained
};

/// `sign(level)`: marks of f minus the level; `step`: f tends to be a multiple of it. The set has marks 0/1.
RotationLeast least_rotation(const std::function<RotationMap(const exact::Real&)>& sign, const RotationMap& set,
                             const exact::Real& step);

}  // namespace findspace::plane
