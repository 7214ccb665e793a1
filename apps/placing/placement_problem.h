// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the `place` of a scene to a placement problem: shapes rotated by their allowed angles, formulas with the bodies
// they speak of. Mistakes are reported at their place in the scene.
#pragma once

#include "common/session.h"
#include "planning/order/problem.h"

namespace findspace::app {

/// Throws Error where the scene has no placement, or one that cannot be computed.
planning::Problem placement_problem(const Session& session);

}  // namespace findspace::app
