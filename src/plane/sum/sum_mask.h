// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Square cells that certainly lie inside the open sum of two sets with arcs (inner_mask.h), and what of a convolution
// may lie outside them: where curves cross far more often than the sum has vertices, only that is arranged.
//
// Why nothing is lost. Of an open sum the faces, edges and vertices with a positive number are the points that lie in
// it, and these alone. A cell, closed, lies in it. So no boundary passes through a cell, no slot without width (an edge
// of number 0 between faces that are inside), no single point that is missing, and no end of either: all that is not
// regular lies outside, or a cell would hold a point that is not in the sum. Outside the cells nothing changes. A curve
// is cut only within cells, an end that is left out lies in one, and a corner is left out only with such an end; so
// around each point outside the cells the same curves and corners are there. They give the same differences between
// the numbers of neighbours. But no number leads across the cells, where curves are missing. Therefore the border of
// the cells is arranged too, and each connected piece of the rest has a point on no curve, whose number is counted
// along a ray through all curves as they were. Cells touch at corners, but what is outside does not connect there.
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

/// Cells with sides of so many grid steps, above 8, for all pairs of parts of a and b; b is bounded. `effort`: as in
/// inner_mask.h. Nothing where doubles are not near enough to the coordinates, or where that would take too long.
std::optional<InnerMask> mask_of_sum(const Operand& a, const Operand& b, std::int64_t side, double effort);

/// The same where the mask pays: an estimated number of crossings well above the number of curves. Curves of the
/// convolution of all pairs of parts of a and b; b is bounded.
std::optional<InnerMask> mask_that_pays(const ConvolutionBuilder& convolution, const Operand& a, const Operand& b);

/// Cuts away what lies in masked cells. `base`: number of the unbounded face of the convolution. Nothing where no
/// points for the numbers are found; then the convolution is as it was.
std::optional<InnerPart> prune(ConvolutionBuilder& convolution, const InnerMask& mask, std::int32_t base);

}  // namespace findspace::plane
