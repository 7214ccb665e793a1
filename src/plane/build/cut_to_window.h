// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A large set of grid polygons as it is within a window: corners are left out where the ring passes the window on the
// same side without them. Guarantee: in the closed window exactly the set; outside it another one, bounded by parts of
// segments between corners of the set. Cost: linear, and one arrangement of what is left. Keywords: clipping, locality,
// winding number, homotopy.
#pragma once

#include <optional>

#include "plane/complex/broad_phase.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// Nothing where that is not much smaller than `a`, or not made: `a` is small, unbounded or not closed, or has parts
/// without interior or edges off the grid.
std::optional<Region> cut_to_window(const Region& a, const PieceBox& window);

}  // namespace findspace::plane
