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

#include "plane/convolution_index.h"
#include "plane/sum_labels.h"

namespace findspace::plane {

/// Grid coordinates, lower bounds below upper ones.
struct Window {
  std::int64_t x0, y0, x1, y1;
};

/// How many curves of the reduced convolution reach into the window; `most` if there are more.
std::size_t curves_in(const ConvolutionIndex& index, const Window& window, std::size_t most);

/// -1 on the open sum, 0 on its boundary, +1 elsewhere.
SignMap window_sum(const ConvolutionIndex& index, const Window& window, const InsideTest& inside);

}  // namespace findspace::plane
