// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Containers that are no boxes: what one closed surface encloses, of flat faces, convex or not, with hollows or
// without; unions, differences and intersections of such; balls, what these have in common, and one less others. It is
// moved so that its box begins at the origin. All of these but the first know what their box, or their balls, have and
// they lack, as convex cells and balls: what meets none of them, and leaves neither box nor balls, lies in the
// container. Guarantee: exact but for volumes. Cost: that of its convex parts and cells. Keywords: irregular container,
// unit load device, spherical tank, constructive solid geometry, container loading.
#pragma once

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

/// Its inside and sides; a shape that is a box leaves it a box. Throws Error: kUnsupported for other shapes and those
/// without bounds, kOutOfRange where one has too many digits.
void set_shape(SolidContainer& container, const plane::Shape& shape, int128 steps);

/// Of what it holds below a height, in cubic units, in doubles.
double volume_below(const SolidProblem& problem, const SolidContainer& container, double height);
double volume_of(const SolidProblem& problem, const SolidContainer& container);

}  // namespace findspace::packing
