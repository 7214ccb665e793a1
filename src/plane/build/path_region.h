// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The set of the points of a chain of straight legs with rational way points, which may cross and cover itself.
// Guarantee: exact. Cost: one arrangement. Keywords: polyline, path.
#pragma once

#include <span>

#include "plane/base/real_vector.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// Of one way point, or of equal ones: a single point. Throws Error(kOutOfRange) as window_between (swept.h) does.
Region region_of_path(std::span<const RealVector> path);

}  // namespace findspace::plane
