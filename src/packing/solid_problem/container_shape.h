// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Containers that are no boxes: what one closed surface encloses, of flat faces, convex or not, with hollows or
// without. It is moved so that its box begins at the origin. Guarantee: exact but for volumes. Cost: that of its convex
// parts. Keywords: irregular container, unit load device, container loading.
#pragma once

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

/// Its inside and sides; a shape that is a box leaves it a box. Throws Error: kUnsupported unless the shape is one
/// solid with flat faces, kOutOfRange where it has too many digits.
void set_shape(SolidContainer& container, const plane::Shape& shape, int128 steps);

/// Of what it holds below a height, in cubic units, in doubles.
double volume_below(const SolidProblem& problem, const SolidContainer& container, double height);
double volume_of(const SolidProblem& problem, const SolidContainer& container);

}  // namespace findspace::packing
