// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact names for places: of those that at most three planes and spheres have in common, the ones at which the distance
// to p is least or greatest. Two spheres meet in the plane where their equations are the same, so any of these is a
// sphere within the planes that hold it: a place on a line, a circle or a sphere about the projection of its centre. A
// cylinder whose axis is normal to a plane meets that like a sphere about the place of the axis. Guarantee: exact
// (nested square roots); nothing where the carriers do not meet, or are more than three. Cost: some ten microseconds.
// Keywords: candidate features, radical plane, power diagram, problem of Apollonius.
#pragma once

#include <span>
#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::space {

struct Ball {
  RealVector center;
  exact::Real radius;
};

/// The nearest first, and the one opposite; where two planes pass through a sphere, both that they meet it in. Of
/// places that are all as near, one.
std::vector<RealVector> name_places(std::span<const HalfSpace> planes, std::span<const Ball> spheres,
                                    const RealVector& p);

}  // namespace findspace::space
