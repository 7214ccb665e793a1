// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Containment in a shape made of others, by containment in some and distance from others: B lies in the closure of A
// less C iff it lies in A and its interior does not meet that of C, and in that of A and A' iff it lies in both; so
// also with t to spare, for t >= 0:
//     eta1(B, A \ C) <= -t  iff  eta1(B, A) <= -t  and  gamma1(B, C) >= t,
// and strictly likewise (distances.md 1.4, of sets that are closures of their interiors). So containers with round
// obstacles have sign maps up to level 0 though they have no convex parts. Guarantee: exact. Keywords: constructive
// solid geometry, configuration space.
#pragma once

#include <vector>

#include "plane/contour/shape.h"

namespace findspace::formula {

struct ContainerPart {
  plane::ShapePtr shape;
  bool without = false;  // B has to keep out of it, not to lie in it
};

/// The shape itself where it is not a difference or intersection (or one of a closure or regularization of such).
std::vector<ContainerPart> container_parts(const plane::ShapePtr& shape);

}  // namespace findspace::formula
