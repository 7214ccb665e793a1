// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact names for places at which a ball touches a surface (surface_ball.h): the place is known in doubles, and so is
// which features of the surface the ball touches there. Internal to surface_ball. Guarantee: a name is a place at which
// the ball touches on the right side and no triangle is nearer, exactly; nothing where square roots do not name it.
// Cost: some hundred microseconds.
#pragma once

#include "distance/surface/surface_ball.h"

namespace findspace::distance {

/// The place nearest to x (or, `farthest`, which several features have to hold) that is `blur` or less from `place`.
std::optional<space::RealVector> named_for_ball(const SurfaceBall& ball, const space::RealVector& x,
                                                const space::Vector& place, bool farthest, double blur);

}  // namespace findspace::distance
