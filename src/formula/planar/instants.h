// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The instants of a motion at which a formula holds at a position. Guarantee: exact for shapes that do not turn. Of
// shapes that rotate an inner and an outer set: a distance changes at most at a known rate (rotation_motion.h), so its
// value in the middle of a piece of time tells its sign in all of it, or the piece is halved. Keywords: time interval,
// continuous collision detection.
#pragma once

#include <vector>

#include "formula/planar/prepared_world.h"
#include "formula/planar/region_bounds.h"

namespace findspace::formula {

/// The marks that the formula has at p, in grid steps, from the start to the end of the motion, 1 where it holds at the
/// instant. Distances with inf or sup keep to the whole time.
plane::Section instants_at(const PreparedWorld& world, const Formula& formula, const exact::RealPoint& p);

/// The signs of each of its sign maps, likewise. Throws Error(kUnsupported) where shapes rotate in time, and for
/// distances in rotation.
std::vector<plane::Section> signs_in_time(const PreparedWorld& world, const Formula& formula,
                                          const exact::RealPoint& p);

/// The same where shapes rotate in time.
InstantBounds instant_bounds_at(const PreparedWorld& world, const Formula& formula, const exact::RealPoint& p);

}  // namespace findspace::formula
