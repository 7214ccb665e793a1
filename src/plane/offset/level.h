// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From a sign map at level 0 to the sign map at any level, for a signed pair distance f = d(p, C) - d(p, O^c)
// (distances.md 3.1): the base map carries - on the open set O, 0 on C \ O, + elsewhere.
//   level > 0: the sign of d(p, C) - level;  level < 0: the sign of |level| - d(p, O^c), never of an erosion of C.
// Guarantee: exact for every level, also at critical ones (mid-lines of gaps, centres of holes); boundary arcs are
// arcs. Cost: that of grid_offset.h for grid polygons, else one convolution with a disc. Source: distances.md 3.5, 3.6.
// Keywords: offset, buffer, parallel curve, clearance.
#pragma once

#include <optional>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

SignMap level_map(const SignMap& base, const exact::Real& level);
/// The same; the base goes as soon as it is not read again.
SignMap level_map(SignMap&& base, const exact::Real& level);

/// level_map(contact_map(a, b), level) part by part (in_batches.h), so that the base is never there as a whole. Nothing
/// where that does not pay, where a set is not bounded, or where bases are kept for other questions (result_store.h).
std::optional<SignMap> contact_level_in_batches(const Region& a, const Region& b, const exact::Real& level);

/// The sign of d(p, C) - radius for a closed set C and radius > 0; + everywhere if C is empty.
SignMap distance_map(const Region& closed, const exact::Real& radius);
SignMap distance_map(Region&& closed, const exact::Real& radius);

}  // namespace findspace::plane
