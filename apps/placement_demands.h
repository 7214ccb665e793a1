// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The scene's "place" as bodies, conditions and objectives of the planning layer, the same in the plane and in space,
// and which shapes have to be rotated for it.
#pragma once

#include "planning/order/problem.h"
#include "session.h"

namespace findspace::app {

struct RotatedShape {
  std::string name, shape;  // a name of its own, and the shape of the scene
  exact::Real degrees;
};

struct PlacementDemands {
  planning::Demands demands;
  std::vector<RotatedShape> rotated;
};

PlacementDemands placement_demands(const Session& session);

}  // namespace findspace::app
