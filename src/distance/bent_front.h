// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Levels at which a bent front (front.h) meets others. It is the line of positions at which a straight edge of B passes
// through the place of A's plane that is `level` away from two parts of A, not both straight: the line's offset is
// c + k*level + w*sqrt(T(level)) with T of degree 2. With a circle that it touches, or another line that it becomes,
// the level is a root of degree 2; with one that is bent as well, of degree 4. With two fronts that pass through one
// point: of degree 2 where they are lines, of 4 where one is a circle. Guarantee: exact numbers; what the numbers show
// to be of the square root's other sign is left out. Of three fronts those that are bent must be so by one T, as in
// symmetric shapes. Cost: microseconds for degree 2, some signs of polynomials for degree 4. Source: elimination.
// Keywords: bisector, Voronoi edge, Hausdorff distance, resultant.
#pragma once

#include <span>

#include "distance/front.h"

namespace findspace::distance {

/// The positions p at which the place between two fronts f (a circle) and g of A, the one on the side of (near_x,
/// near_y), lies on the line `edge` moved by p. Nothing where f and g are concentric.
std::optional<Front> bent_front(const Front& edge, const Front& f, const Front& g, double near_x, double near_y);

/// The levels in [low, high] at which the fronts, two or three, the first of them bent, meet.
std::vector<exact::Real> bent_levels(std::span<const Front* const> fronts, double low, double high);

}  // namespace findspace::distance
