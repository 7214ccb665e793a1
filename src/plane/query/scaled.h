// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A marked complex on a finer grid: every coordinate times a positive integer. Guarantee: exact. Cost: linear.
#pragma once

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

CellComplex scaled(CellComplex complex, std::int64_t factor);

}  // namespace findspace::plane
