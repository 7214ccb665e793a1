// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The marks of a set of boxes along a line. Guarantee: exact; every place where the line meets a coordinate of the grid
// at which the mark changes is a stop. Cost: the coordinates, each located. Keywords: cross section, chord.
#pragma once

#include "plane/query/section.h"
#include "space/box/box_complex.h"

namespace findspace::space {

/// Of through + t * direction, by growing t. `direction` is not zero.
plane::Section section(const BoxComplex& set, const RealVector& through, const RealVector& direction);

}  // namespace findspace::space
