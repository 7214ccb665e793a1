// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Curves of a reduced convolution that lie on one line, overlap and have the same inner side say the same along what
// they share: they become one curve. On staircases and combs very many do, and pairs of them would be met one by one.
// Guarantee: what the curves say about every point is the same, ends included: inside a curve the set lies behind its
// whole line, and of those that end at one place one that hides directions is enough. Cost: a look at about two times
// the square root of their number; where many overlap, O(n log n). Keywords: collinear overlap, coincident edges.
#pragma once

#include "plane/grid/reduced_convolution.h"

namespace findspace::plane {

/// Do so many overlap that it pays to make them one? By a sample, always the same; false where there are few curves.
bool merging_pays(const ReducedConvolution& convolution);

/// Its ends must be grid points. What is left keeps its order.
ReducedConvolution merged_curves(ReducedConvolution convolution);

}  // namespace findspace::plane
