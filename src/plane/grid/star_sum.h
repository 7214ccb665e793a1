// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open sum of two grid polygons whose reduced convolution is a single closed ring that is seen whole from one point
// (star_shaped.h): the boundary of the sum lies on that ring, so it is the ring. Guarantee: the same cells and marks as
// by arranging. Cost: linear. Keywords: reduced convolution.
#pragma once

#include <optional>

#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// Nothing where the curves are no such ring; the convolution then is as before. It must be that of two bounded faces.
std::optional<SignMap> star_sum(ReducedConvolution& convolution);

}  // namespace findspace::plane
