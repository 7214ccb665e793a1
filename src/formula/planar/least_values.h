// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least and greatest values of distances over positions. Guarantee: as that of distance/planar_least/extremum.h
// and, where only bounds are known, of best_position.h there. Keywords: global minimum, argmin, branch and bound.
#pragma once

#include "distance/planar_least/best_position.h"
#include "distance/planar_least/extremum.h"
#include "formula/planar/prepared_world.h"

namespace findspace::formula {

/// The global minimum of a distance and the positions that have it: `distance -> min`. Made once a world.
distance::Extremum least(const PreparedWorld& world, const Distance& wanted);
/// The same with the shapes at rest.
distance::Extremum least_at_rest(const PreparedWorld& world, const Roles& roles);
/// Its least or greatest value over positions in grid steps (in degrees, of one in rotation), where is_bounded;
/// `goes_on`: `over` is what was cut out of an unbounded set.
distance::Extremum best_position(const PreparedWorld& world, const Distance& wanted,
                                 const distance::PositionBounds& over, distance::Sense sense, bool goes_on = false);

/// 0 where the value is least, + elsewhere.
plane::SignMap minimiser_map(distance::Extremum least);

}  // namespace findspace::formula
