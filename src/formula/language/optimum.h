// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What `minimize`, `maximize` and `distance -> min` find: the best value over a set of positions, and the positions
// that have it, in whatever form the set is: cells of the plane, boxes, one convex set, intervals of a line. Guarantee:
// exact where `proven`. Keywords: constrained minimum, argmin, infimum.
#pragma once

#include <optional>

#include "exact/number/real.h"

namespace findspace::formula {

struct OptimalValue {
  /// Nothing where there is no finite one: the set is empty, or unbounded in this sense, or the distance undefined.
  std::optional<exact::Real> value;  // in the scene's unit: of the objective
  bool unbounded = false;            // no bound in this sense
  bool attained = false;             // by a position of the set; else it is an infimum (supremum)
  bool proven = true;
  /// Where not proven (distance/planar_least/extremum.h), in the scene's unit; infinite: not known.
  double bound = 0, within = 0;
};

template <class Set>
struct OptimumOf : OptimalValue {
  Set at;  // in grid steps: of the set, or of its closure if not attained
};

}  // namespace findspace::formula
