// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rows of signs on the same lines, walked side by side: combined() of ray_map.h, and the same for sums. Guarantee: as
// the rows'. Cost: of n rows log n comparisons an event, and what changes of the sum or the extreme sign; a function of
// all signs is asked twice an event. Keywords: k-way merge, sweep.
#pragma once

#include <span>

#include "plane/base/sign_sum.h"
#include "space/rays/ray_map.h"

namespace findspace::space {

/// The least sign of the rows at every place, or the greatest.
RayRow extreme(std::span<const RayRow> rows, bool least);
/// -1 where the sum over the signs of the rows is more than 0, and +1 elsewhere.
RayRow summed(std::span<const RayRow> rows, const plane::SignSum& sum);

}  // namespace findspace::space
