// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Pieces of a convolution that are the same, with the same direction, as one that counts so often: sums of sums repeat
// their edges, and then each edge is found once for every pair whose sum it is. An arrangement would compare all of
// these with each other. Numbers are sums over curves and corners, so equal ones may count together; a curve that had
// one corner at its end then has several, whose counts add up to its own. Where ends of different curves become one
// point, none of these is smooth there any more (arrangement.h): they may meet again.
// Guarantee: the same winding numbers everywhere; points are found to be the same where their coordinates are rational.
// Cost: O(n log n). Keywords: duplicates, multiplicity.
#pragma once

#include "plane/sum/convolution.h"

namespace findspace::plane {

void merge_equal_pieces(ConvolutionBuilder& convolution);

}  // namespace findspace::plane
