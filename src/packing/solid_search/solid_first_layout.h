// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A first layout of solids: the largest first, each where it comes to stand lowest, then farthest back and left. Places
// over corners of what stands, and some at random, are tried; from each the solid falls, and slides back and left, as
// long as that gains. Where containers have lids, the first that has a place is taken. Some orders are tried; the
// layout that leaves out least is kept, of equal ones the lowest. Guarantee: no overlaps, in doubles; where
// conditions of pairs left no place it says so. Cost: lines
// through what stands. Keywords: bottom left back.
#pragma once

#include "packing/search/separation.h"
#include "packing/solid_depth/solid_column.h"

namespace findspace::packing {

/// The value of a copy of each part: as stated, or its volume.
std::vector<double> values_of(const SolidProblem& problem);

FirstLayoutOf<SolidPose> first_layout(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column,
                                      std::uint64_t seed);

}  // namespace findspace::packing
