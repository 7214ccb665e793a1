// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// In what order the nodes of a convolution are passed, once round each closed walk: `next`, `smooth_start`,
// `smooth_end`, `rotation` and `extra` of every node. Pairs of turns that stay at one point are walked through.
// Guarantee: exact. Cost: O(nodes). Source: convolution.h, which alone uses this.
#pragma once

#include <vector>

#include "plane/sum/convolution_nodes.h"

namespace findspace::plane {

/// A walk that stays at one point, the sum of the centres of two turns: an arc against one of the same radius and
/// their neighbours, round and round.
struct StillWalk {
  Index at[2];
  int rounds;  // of the displaced path about the point
};

/// Returns the walks that have no node.
std::vector<StillWalk> connect_nodes(ConvolutionNodes& nodes);

}  // namespace findspace::plane
