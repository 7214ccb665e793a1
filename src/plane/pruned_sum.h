// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open Minkowski sum of jagged polygons, whose convolution has far more crossings than the sum has vertices. Three
// exact prunings before arranging (architecture.md 3): curves that arise at reflex vertices lie inside the sum and are
// dropped (reduced convolution); so is what lies in cells that are certainly inside (InnerMask); and a face that has
// the inner side of a curve is inside. What is left to decide, a few faces, edges and vertices, is decided by the
// displaced winding number of the whole convolution at one of their points. Guarantee: the same cells and marks as by
// arranging the whole convolution. Cost: crossings near the boundary, and for each decision one pass over the
// convolution. Source: Behar & Lien 2011 (reduced convolution); winding.h. Keywords: reduced convolution, hole filter,
// collision test.
#pragma once

#include <span>

#include "plane/convolution.h"
#include "plane/inner_mask.h"

namespace findspace::plane {

/// Whether pruning pays: a convolution of grid segments with an estimated number of crossings well above its size.
bool pruning_pays(const ConvolutionBuilder& convolution);

/// -1 on the open sum, 0 on its boundary, +1 elsewhere. `convolution` inward, of grid segments; `base`: winding number
/// of the unbounded face; `pairs`: outlines of the bounded pairs of parts for the mask.
SignMap pruned_open_sum(ConvolutionBuilder convolution, std::int32_t base, std::span<const InnerMask::Pair> pairs);

}  // namespace findspace::plane
