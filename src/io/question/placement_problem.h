// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the `place` of a scene to a placement problem: shapes rotated by their allowed angles, formulas with the bodies
// they speak of. Mistakes are reported at their place in the scene.
#pragma once

#include "io/question/asked_scene.h"
#include "planning/order/problem.h"

namespace findspace::io {

/// Throws Error where the scene has no placement, or one that cannot be computed.
planning::Problem placement_problem(const AskedScene& asked);

}  // namespace findspace::io
