// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rotations that round: see transform.h. Used by transform.cpp only.
#pragma once

#include "plane/build/transform.h"

namespace findspace::plane {

/// Rotated by `quarters` times 90 degrees plus `rest` degrees, 0 < rest < 90. The angle's sine and cosine are taken to
/// 2^-55.
CellComplex rotated_on_grid(const CellComplex& complex, const GridPoint& about, int quarters, const exact::Real& rest,
                            double step, Rounding& rounding);

}  // namespace findspace::plane
