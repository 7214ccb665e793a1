// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The open Minkowski sum of two sets of grid polygons within a window, from those curves of its reduced convolution
// that reach into it: for questions about one place of a sum that would be costly as a whole. Guarantee: inside the
// window the same cells and marks as of the whole sum; the window's border and what lies outside count as in the sum,
// but for points of the border that are certainly not. Cost: a search for the curves (convolution_index.h), crossings
// inside the window, and a winding number for each cell the curves do not decide. Source: reduced_convolution.h,
// sum_labels.h. Keywords: local arrangement, clipping.
#pragma once

#include <span>

#include "plane/grid/boundary_box.h"
#include "plane/grid/convolution_index.h"
#include "plane/grid/sum_labels.h"

namespace findspace::plane {

/// The curves of the reduced convolution that reach into the window, `most` of them if there are more.
std::vector<ConvolutionIndex::Curve> curves_in(const ConvolutionIndex& index, const GridBox& window, std::size_t most);
/// Those of them that reach into a window inside the first one.
std::vector<ConvolutionIndex::Curve> curves_in(const ConvolutionIndex& index, const GridBox& window,
                                               std::span<const ConvolutionIndex::Curve> among);

/// -1 on the open sum, 0 on its boundary, +1 elsewhere; `curves` are all that reach into the window.
SignMap window_sum(const ConvolutionIndex& index, const GridBox& window,
                   std::span<const ConvolutionIndex::Curve> curves, const InsideTest& inside);

}  // namespace findspace::plane
