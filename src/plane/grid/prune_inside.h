// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Cuts away what of a reduced convolution lies in cells that are certainly inside the sum (inner_mask.h), where jagged
// polygons make far more crossings than the sum has vertices. Guarantee: what is cut away lies in the open sum; the
// curves are cut on grid lines. Cost: curves * cells along each, and the mask. Keywords: pruning, hole filter.
#pragma once

#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// Whether cutting pays: an estimated number of crossings well above the number of curves.
bool pruning_pays(const ReducedConvolution& convolution);

/// `convolution` is that of a and b.
ReducedConvolution prune_inside(ReducedConvolution convolution, const GridOperand& a, const GridOperand& b);

}  // namespace findspace::plane
