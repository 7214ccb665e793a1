// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A first layout without overlaps: the largest part first, each as far left as a corner of the no-fit polygons of those
// before it, or of the strip, allows. Guarantee: no overlaps, in doubles. Cost: corners times parts near each.
// Keywords: bottom-left, constructive heuristic.
#pragma once

#include <vector>

#include "packing/nfp/field_table.h"
#include "packing/problem/problem.h"

namespace findspace::packing {

struct DoubleLayout {
  std::vector<Pose> poses;
  double length = 0;
};

DoubleLayout first_layout(const Problem& problem, const FieldTable& table);

}  // namespace findspace::packing
