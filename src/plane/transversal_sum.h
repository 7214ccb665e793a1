// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open sum of two grid polygons whose reduced convolution is in general position: its curves meet at common ends,
// touch each other with their ends, or cross, two at a point. Its boundary is then made of the closed walks along the
// outer sides of the curves that turn at every crossing and never pass an inner side; no arrangement is needed.
// Guarantee: the same cells and marks as by arranging. Cost: that of the pairs of curves in a grid of cells. Source:
// Behar & Lien 2011. Keywords: reduced convolution, outer loops.
#pragma once

#include <optional>

#include "plane/sum_labels.h"

namespace findspace::plane {

/// Nothing where the curves are not in general position; the convolution then is as before. It must be that of two
/// bounded faces, and may be pruned.
std::optional<SignMap> transversal_sum(ReducedConvolution& convolution, const InsideTest& inside);

}  // namespace findspace::plane
