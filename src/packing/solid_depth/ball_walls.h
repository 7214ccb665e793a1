// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a part lies within a ball: the positions at which all of its corners do, and all of its balls. They are what
// balls about points have in common, a convex set. The search takes a polytope in it. Its planes touch the set at
// points seen from the middle in directions that are spread evenly; then it shrinks about the middle until its corners
// lie in the set. Guarantee: that of doubles; what is lost is some two hundredths of the set's size, next to nothing
// where a part nearly fills the ball. Cost: a hull of kDirections points. Keywords: inscribed polytope, intersection of
// balls, polar dual, spherical container.
#pragma once

#include <vector>

#include "packing/solid_depth/container_walls.h"

namespace findspace::packing {

/// The half-spaces normal . x <= offset of it, x the place of a part of this body; `steps` of the body's grid in a
/// unit, at its scale. Where the part fits nowhere no x is in all.
std::vector<ContainerWalls::Plane> ball_walls(const space::Body& body, double steps, const ContainerWalls::Ball& ball,
                                              double edge);
/// The places of the ball, from a part at the origin, at which it is not known to lie within.
void add_ball_walls(const space::Body& body, double steps, const ContainerWalls::Ball& ball, double edge,
                    ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks);

}  // namespace findspace::packing
