// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Topology of sets of boxes, open, closed or neither (distances.md 8.1). Guarantee: exact. Cost: 27 cells a vertex at
// most. Keywords: closure, interior, regularisation, star of a cell.
#pragma once

#include "space/box/box_complex.h"

namespace findspace::space {

/// Of sets of marks 0 and 1.
BoxComplex closure(const BoxComplex& set);
BoxComplex interior(const BoxComplex& set);
BoxComplex complement(const BoxComplex& set);
BoxComplex boundary(const BoxComplex& set);     // closure without interior
BoxComplex regularized(const BoxComplex& set);  // closure of the interior

}  // namespace findspace::space
