// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which curves of an offset may meet. They lie one after the other, and where they go on in one quadrant of directions
// the box of any stretch of them is that of its two ends: no box of a single curve is made before it is asked for.
// Guarantee: none missing. Cost: linear, a tree over the stretches, and halvings where two of them are near each other.
// Keywords: monotone chain.
#pragma once

#include <vector>

#include "plane/offset/offset_curves.h"

namespace findspace::plane {

struct PiecePair {
  Index i, j;  // i < j
};

/// Pairs whose boxes meet. Left out are those where one follows the other, and those in one row of pieces that follow
/// each other and all go right, or all left: what advances so meets itself nowhere. In the order of a binary tree over
/// the pieces, which numbers the crossings.
std::vector<PiecePair> near_pairs(const OffsetCurves& curves);

}  // namespace findspace::plane
