// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The same complex with its cells numbered by where they lie: vertices from left to right and upwards, edges by their
// left ends and there counter-clockwise, faces by their first half-edge. So a set is written in the same bytes however
// it was put together, whatever the order of the shapes it is made of. Guarantee: the same point set with the same
// marks; supporting curves and points of the geometry keep their places. Cost: O(n log n) exact comparisons of n
// vertices, few of which are not decided by intervals. Source: distances.md 8.1. Keywords: canonical form, normal form.
#pragma once

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

CellComplex in_order(CellComplex complex);

}  // namespace findspace::plane
