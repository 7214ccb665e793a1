// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One pass over any number of marked complexes: the common refinement of their cells, a function of the vector of marks
// on every vertex, edge and face, and the merging of cells that agree. Plain (not regularised) set semantics: slots,
// cracks, isolated points, open and closed ends survive. Guarantee: exact. Cost: one arrangement, plus operands *
// cells. Source: decision 1; distances.md 4.2, 8.1. Keywords: overlay, Boolean operation, map overlay.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// The complex that carries rule(marks) on every cell, marks[k] being the mark of operand k there.
CellComplex overlay(std::span<const CellComplex* const> operands,
                    const std::function<Mark(std::span<const Mark>)>& rule);

/// Boolean combinations of regions (marks 0/1), of any number at once. Cost: one arrangement. Unions mostly need none
/// (walk/unite.h).
Region unite_arranged(std::span<const Region* const> regions);
Region intersect(std::span<const Region* const> regions);
/// first \ (all others)
Region subtract(std::span<const Region* const> regions);

/// The same complex, whose cells are merged as far as they can be, with marks rule(mark); merged again where the rule
/// unites marks. The rule is asked once for each mark.
CellComplex remark(CellComplex complex, const std::function<Mark(Mark)>& rule);
/// Of minus the function.
inline SignMap negated(SignMap map) {
  return remark(std::move(map), [](Mark k) { return Mark(-k); });
}

}  // namespace findspace::plane
