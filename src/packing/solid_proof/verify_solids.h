// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a layout in space keeps its promises: every part within the walls, the floor and the height by the edge, no
// two interiors meeting, gaps as wide as asked for, and the right number of copies. Guarantee: exact, on the original
// shapes: Phi-functions of convex parts, or surfaces where parts were rounded; only depths are doubles. Cost: the pairs
// of parts whose boxes meet. Keywords: layout validation, collision check.
#pragma once

#include <vector>

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

struct SolidFault {
  enum class Kind { kOverlap, kGap, kOutside, kCount };
  Kind kind = Kind::kOverlap;
  /// kOverlap, kGap: items of the layout; kOutside: an item; kCount: a part.
  std::size_t first = 0, second = 0;
  double depth = 0;            // kOverlap: of the convex parts; kOutside: how far outside; kCount: copies too many
  std::array<double, 3> at{};  // where, but of kCount
};

struct SolidVerdict {
  std::vector<SolidFault> faults;  // the deepest first
  Fraction used;                   // the greatest z of a part
  double density = 0;              // of the parts in the container up to its height

  bool is_feasible() const { return faults.empty(); }
};

SolidVerdict verify(const SolidProblem& problem, const SolidLayout& layout);

}  // namespace findspace::packing
