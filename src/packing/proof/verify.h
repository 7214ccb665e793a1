// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a layout keeps its promises: every part inside the strip or its sheet by the edge and outside the zones that
// keep it out, no two interiors meeting, gaps as wide as asked for, conditions of pairs, allowed angles, fixed parts
// where they stand, and the right number of copies and sheets. Guarantee: exact, on the original shapes; only depths
// are doubles. Polygons are decided by signs of lattice points (interiors.h), parts with arcs by the formula of their
// gap at the exact position (pair_formula.h). Cost: the pairs of parts whose boxes meet. Keywords: layout validation,
// nesting check.
#pragma once

#include <vector>

#include "packing/problem/problem.h"

namespace findspace::packing {

struct Fault {
  enum class Kind { kOverlap, kGap, kCondition, kOutside, kAngle, kZone, kCount, kSheets, kFixed };
  Kind kind = Kind::kOverlap;
  /// kOverlap, kGap, kCondition: items of the layout; kOutside, kAngle, kZone: an item; kCount, kFixed: a part;
  /// kSheets: a kind of sheet.
  std::size_t first = 0, second = 0;
  double depth = 0;     // kOverlap: penetration depth; kOutside: how far outside; kCount: copies too many
  double x = 0, y = 0;  // where, but of kAngle, kCount and kSheets
};

struct Verdict {
  std::vector<Fault> faults;  // the deepest first
  Fraction used;              // the greatest x of a part; on the last sheet
  double density = 0;         // of the parts in the layout's strip or sheets

  bool feasible() const { return faults.empty(); }
};

Verdict verify(const Problem& problem, const Layout& layout);

}  // namespace findspace::packing
