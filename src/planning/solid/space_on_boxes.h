// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The best position of a placement in space over a set of boxes. Guarantee: exact; where the objectives leave an open
// or unbounded set, or none takes the least values and any position will do, a point inside the first box.
#pragma once

#include "planning/order/placement.h"
#include "planning/solid/space_goals.h"
#include "space/box/box_complex.h"

namespace findspace::planning {

SpaceBest best_on_boxes(const space::BoxComplex& positions, const SpaceGoals& goals, const exact::Real& step,
                        Pick pick = Pick::kBest);

/// What keeps the conditions on coordinates.
std::vector<space::IntervalBox> with_fixed(std::vector<space::IntervalBox> boxes, const SpaceGoals& goals);

}  // namespace findspace::planning
