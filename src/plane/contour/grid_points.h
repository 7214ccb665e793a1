// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rings given as arrays of doubles, put on the grid in one pass. Guarantee: as Grid::nearest. Cost: a few nanoseconds a
// point. Keywords: quantisation.
#pragma once

#include <array>
#include <span>

#include "plane/contour/decimal_grid.h"

namespace findspace::plane {

/// Segments between the nearest grid points. Errors as Grid::nearest, their place "NAME, vertex K".
Contour grid_contour(const Grid& grid, std::span<const std::array<double, 2>> points, const char* name,
                     RoundingLog& log);

}  // namespace findspace::plane
