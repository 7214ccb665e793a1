// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open Minkowski sum of sets of grid polygons, the common case. Only curves that can be boundary are arranged
// (decision 8): those of the reduced convolution, where they cross a lot without what lies certainly inside;
// two convex polygons need no arrangement. Guarantee: the same cells and marks as by arranging the whole convolution.
// Cost: crossings near the boundary; for the few cells the curves do not decide, one pass over the whole convolution
// each. Source: Behar & Lien 2011 (reduced convolution); winding.h. Keywords: reduced convolution, hole filter,
// collision test.
#pragma once

#include "plane/grid/sum_labels.h"

namespace findspace::plane {

/// -1 on the open sum, 0 on its boundary, +1 elsewhere; `inside` decides for single points. At least one operand is
/// bounded.
SignMap grid_sum(const GridOperand& a, const GridOperand& b, const InsideTest& inside);

}  // namespace findspace::plane
