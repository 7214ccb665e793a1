// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pieces of a convolution that are the same, with the same direction, as one that counts so often: sums of sums repeat
// their edges, and then each edge is found once for every pair whose sum it is. An arrangement would compare all of
// these with each other. Guarantee: the same winding numbers everywhere; points are found to be the same where their
// coordinates are rational. Cost: O(n log n). Keywords: duplicates, multiplicity.
#pragma once

#include "plane/sum/convolution.h"

namespace findspace::plane {

void merge_equal_pieces(ConvolutionBuilder& convolution);

}  // namespace findspace::plane
