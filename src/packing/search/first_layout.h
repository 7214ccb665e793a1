// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A first layout without overlaps: the largest part first, or the most valuable one for its area where all cannot fit,
// each as far left as a corner of the no-fit polygons of those before it, or of a container, allows. Guarantee: no
// overlaps, in doubles, unless it says so. Cost: corners times parts near each. Keywords: bottom-left, constructive
// heuristic.
#pragma once

#include <vector>

#include "packing/search/separation.h"

namespace findspace::packing {

using FirstLayout = FirstLayoutOf<Pose>;

/// The value of a copy of each part: as stated, or its area.
std::vector<double> values_of(const Problem& problem);

FirstLayout first_layout(const Problem& problem, const FieldTable& table, const Row& row);

}  // namespace findspace::packing
