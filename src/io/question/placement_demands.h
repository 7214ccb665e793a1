// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The scene's "place" as bodies, conditions and objectives of the planning layer, the same in the plane and in space,
// and which shapes have to be rotated for it. Mistakes are reported at their place in the scene.
#pragma once

#include "io/question/asked_scene.h"
#include "planning/order/demands.h"

namespace findspace::io {

planning::AskedDemands placement_demands(const AskedScene& asked);

}  // namespace findspace::io
