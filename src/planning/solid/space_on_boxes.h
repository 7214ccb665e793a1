// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The best position of a placement in space over a set of boxes. Guarantee: exact; where the objectives leave an open
// or unbounded set, a point inside its first box.
#pragma once

#include "planning/solid/space_goals.h"
#include "space/box/box_complex.h"

namespace findspace::planning {

SpaceBest best_on_boxes(const space::BoxComplex& positions, const SpaceGoals& goals, const exact::Real& step);

}  // namespace findspace::planning
