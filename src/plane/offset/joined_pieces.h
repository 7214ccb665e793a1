// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The arrangement of pieces that meet in common ends alone, under one point each: what walks along boundaries leave.
// Guarantee: exact. Cost: linear, and one vertical ray a connected component (nesting.h). Keywords: planar map.
#pragma once

#include <span>
#include <vector>

#include "plane/complex/arrangement.h"

namespace findspace::plane {

/// Edge k is piece k. `isolated`: points on no piece.
Arrangement arrange_joined(exact::Geometry geometry, std::vector<Piece> pieces, std::span<const Index> isolated,
                           Memory memory = kHeap);

}  // namespace findspace::plane
