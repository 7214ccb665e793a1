// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All bodies placed at once in space (distances.md 6.3), where the faces of all shapes are parallel to the axes: for
// every body the set of all positions for which the others can still be placed, and one complete placement, which
// keeps the conditions on coordinates: body after body at its best place, or at any where there is none. Every
// condition is a set of boxes for one position or for the difference of two; a choice of one box of each leaves boxes
// for all positions (difference_boxes.h). Choices that can add nothing to what was found are passed over. Guarantee:
// exact for any number of bodies and conditions, strict ones included; where the time limit comes first the regions
// hold certain positions only and `unproven` says so. Cost: exponential in the number of pairs. Throws
// Error(kUnsupported) for other shapes, for several angles and for conditions between more than two bodies. Keywords:
// configuration space, projection.
#pragma once

#include "planning/order/placement.h"
#include "planning/solid/space_problem.h"

namespace findspace::planning {

using SpaceSimultaneous = TogetherOf<space::BoxComplex, space::RealVector>;

SpaceSimultaneous place_together_in_space(const SpaceProblem& problem, const Limit& limit);

}  // namespace findspace::planning
