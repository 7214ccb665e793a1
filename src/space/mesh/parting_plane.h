// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a plane parts two small sets of points in space. The place nearest to 0 of the differences of two points is
// walked to, from one direction to the next; each is rounded to integers and looked at exactly. Guarantee: where it
// says so, a plane with no point on it lies between the sets; nothing is said where it does not, or where coordinates
// are beyond 2^40. Cost: at most 16 times a product for each point. Source: Gilbert, Johnson and Keerthi 1988.
// Keywords: separating plane, GJK, broad phase.
#pragma once

#include <span>

#include "space/polytope/polytope.h"

namespace findspace::space {

bool plane_parts(std::span<const Point> p, std::span<const Point> q);

}  // namespace findspace::space
