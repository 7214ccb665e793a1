// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open sum of two grid polygons whose boundary is made of rings that do not touch: the closed walks along the outer
// sides of the curves of the reduced convolution that turn at every crossing and never pass an inner side. Where curves
// run along each other with opposite inner sides (a slot of no width may be left between them) and where inner sides
// surround a point (it may be missing), the displaced winding number decides. No arrangement is needed.
// Guarantee: the same cells and marks as by arranging. Cost: that of the pairs of curves in a grid of cells. Source:
// Behar & Lien 2011. Keywords: reduced convolution, outer loops.
#pragma once

#include <optional>

#include "plane/grid/sum_labels.h"

namespace findspace::plane {

/// Nothing where there is a slot or a missing point, or rings touch; the convolution then keeps its curves and has
/// points that none uses. It must be that of two bounded faces, and may be pruned.
std::optional<SignMap> transversal_sum(ReducedConvolution& convolution, const InsideTest& inside);

}  // namespace findspace::plane
