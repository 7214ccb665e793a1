// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a shape tree alone says of the set: never wrong where it says yes. Every set is bounded, or its complement is;
// so the sum of two closed sets is closed, and so is the hull of some. Guarantee: exact in this sense. Cost: the nodes.
// Source: distances.md 1.2.
#pragma once

#include "exact/number/tried.h"
#include "plane/contour/shape.h"

namespace findspace::space {

/// Closed and without sheets, lines and seams of its own: the closure of its interior.
bool is_solid(const plane::Shape& shape);
bool is_closed(const plane::Shape& shape);
bool is_open(const plane::Shape& shape);

/// Whether the closure may fill walls within: two sets of a union that lack boundary have faces that lie on each other.
/// Of shapes that have a body. Cost: such sets as bodies, if there are two.
bool may_lack_walls(const plane::Shape& shape);
exact::Refusal walls_are_lacking();

/// A union, intersection or difference that is translated or mirrored, as that of translated or mirrored sets; else
/// nothing.
plane::ShapePtr moved_inward(const plane::Shape& shape);

}  // namespace findspace::space
