// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A large disc inside a set, in numbers: where another set comes nearer to its centre than its radius, the two overlap.
// Guarantee: the open disc, its radius a little less than found, lies in the set; it is not always the largest. Cost:
// some hundred point queries at most. Keywords: pole of inaccessibility, inscribed circle.
#pragma once

#include "distance/planar_features/feature_tree.h"

namespace findspace::distance {

struct InnerDisc {
  double x = 0, y = 0, radius = 0;  // 0: none found
};

InnerDisc inner_disc(const FeatureTree& tree);

/// How deep a place lies in a set, negative outside; nothing where numbers cannot tell.
std::optional<double> depth_in(const FeatureTree& tree, double x, double y);

}  // namespace findspace::distance
