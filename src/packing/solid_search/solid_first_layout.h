// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A first layout of solids: the largest first, each where it comes to stand lowest, then farthest back and left. Places
// over corners of what stands, and some at random, are tried; from each the solid falls, and slides back and left, as
// long as that gains. Some orders are tried, the lowest layout is kept. Guarantee: no overlaps, in doubles. Cost: lines
// through what stands. Keywords: bottom left back.
#pragma once

#include "packing/search/separation.h"
#include "packing/solid_depth/solid_table.h"

namespace findspace::packing {

LayoutInDoubles<SolidPose> first_layout(const SolidProblem& problem, const SolidTable& table, std::uint64_t seed);

}  // namespace findspace::packing
