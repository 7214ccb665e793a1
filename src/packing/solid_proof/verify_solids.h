// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a layout in space keeps its promises: every part within the container and the height by the edge, no
// two interiors meeting, gaps as wide as asked for, conditions of pairs, the right number of copies, fixed solids where
// they stand, and no more containers than there are. Guarantee: exact, on the original shapes: Phi-functions of convex
// parts, or surfaces where parts were rounded; only depths are doubles. Cost: the pairs of parts whose boxes meet, and
// those with conditions. Keywords: layout validation, collision check.
#pragma once

#include <vector>

#include "packing/solid_problem/solid_problem.h"

namespace findspace::packing {

struct SolidFault {
  enum class Kind { kOverlap, kGap, kOutside, kCount, kContainers, kCondition, kFixed };
  Kind kind = Kind::kOverlap;
  /// kOverlap, kGap, kCondition: items of the layout; kOutside: an item; kCount, kFixed: a part; kContainers: a kind.
  std::size_t first = 0, second = 0;
  double depth = 0;  // kOverlap: of the convex parts; kOutside: how far outside; kCount, kContainers: how many too many
  std::array<double, 3> at{};  // where, or where it should stand, but of kCount and kContainers
};

struct SolidVerdict {
  std::vector<SolidFault> faults;  // the deepest first
  Fraction used;                   // the greatest z of a part, in the last container
  double density = 0;              // of the parts in the container up to its height, or in all

  bool is_feasible() const { return faults.empty(); }
};

SolidVerdict verify(const SolidProblem& problem, const SolidLayout& layout);

}  // namespace findspace::packing
