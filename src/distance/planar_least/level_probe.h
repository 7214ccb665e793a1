// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One question of the searches for an extremum: which positions of a set have a function at a level, which beyond it?
// Guarantee: exact. Cost: one sign map and an overlay.
#pragma once

#include "distance/planar_features/t_distance.h"

namespace findspace::distance {

/// Marks of positions of the set: at the level; beyond it.
inline constexpr plane::Mark kOn = 1, kBeyond = 2;

/// `turn`: +1 where less is beyond, -1 where more is.
plane::CellComplex probe(const PositionFunction& f, const exact::Real& level, const plane::Region& over, int rotation);
/// The positions at the level, as a region.
plane::Region on_level(plane::CellComplex probed);

}  // namespace findspace::distance
