// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Merging of cells that agree, so that a complex has no cell that could be dropped without changing the set
// (distances.md 8.1): an edge whose two sides and itself carry one mark; a vertex whose star carries one mark; a vertex
// that joins two edges of one supporting curve with equal marks. Marks decide, never geometry alone: cracks, whiskers
// and isolated points stay. Guarantee: the same point set for every mark. Cost: O(cells), one exact comparison for each
// component's smallest vertex.
#pragma once

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// `raw` needs vertices, edges (with marks), half_edges (next, face), faces (marks; outer, inner and isolated are
/// rebuilt) and the `face` of isolated vertices. SupportingCurves and points nobody uses any more are dropped from the
/// geometry.
CellComplex simplify(CellComplex raw);

}  // namespace findspace::plane
