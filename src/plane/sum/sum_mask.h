// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Square cells that certainly lie inside the open sum of two sets with arcs (inner_mask.h), and what of a convolution
// may lie outside them: where curves cross far more often than the sum has vertices, only that is arranged. Curves are
// missing within the cells, so no winding number leads across them. Therefore the border of the cells is arranged too,
// and each connected piece of the rest has a point whose number is counted along a ray through all curves.
//
// Guarantee: outside the cells all curves are there and all numbers right; the cells lie in the open sum. Cost: the
// mask, the cells along each curve, and a comparison of each curve with the points above or below it.
// Keywords: pruning, hole filter, bitmap Minkowski sum.
#pragma once

#include <optional>

#include "plane/complex/winding.h"
#include "plane/grid/inner_mask.h"
#include "plane/sum/convolution.h"
#include "plane/sum/operand.h"

namespace findspace::plane {

/// Where the mask pays: an estimated number of crossings well above the number of curves. Curves of the convolution of
/// all pairs of parts of a and b; b is bounded.
std::optional<InnerMask> mask_that_pays(const ConvolutionBuilder& convolution, const Operand& a, const Operand& b);

/// Cuts away what lies in masked cells. `base`: number of the unbounded face of the convolution. Nothing where no
/// points for the numbers are found; then the convolution is as it was.
std::optional<InnerPart> prune(ConvolutionBuilder& convolution, const InnerMask& mask, std::int32_t base);

}  // namespace findspace::plane
