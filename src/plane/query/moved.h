// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Marked complexes moved by any exact vector; by grid vectors alone see translated() in transform.h. Guarantee: exact;
// the grid does not bound where the set goes. Cost: linear. Keywords: translation.
#pragma once

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// {s + by}.
CellComplex moved(CellComplex complex, const exact::RealPoint& by);

}  // namespace findspace::plane
