// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The closed set of rings that touch themselves or each other in corners they have in common: a hole that reaches its
// ring, two holes that meet in a point. Such sets are what sums and differences leave, and drawings hold them as rings.
// Rings that meet anywhere else are not taken: contour.h says what is wrong with them. Guarantee: exact. Cost: one
// arrangement of the edges. Keywords: weakly simple polygon, even-odd rule, bow tie.
#pragma once

#include <optional>
#include <span>

#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

enum class RingRule {
  kEvenOdd,  // in any order and direction: what an odd number of rings goes round
  kHoles  // an outer ring and its holes, each without a corner that it visits twice, none in another but in the first
};

/// Nothing where no corner occurs twice, the rings meet elsewhere, or do not lie as the rule asks.
std::optional<Region> region_of_touching_rings(std::span<const Contour> rings, RingRule rule);

}  // namespace findspace::plane
