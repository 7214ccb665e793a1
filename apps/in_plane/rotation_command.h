// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verbs `map`, `check`, `measure` and `explain` where the moving shape rotates: "free": "angle" or "pose", --angle,
// distances with rotating=.
#pragma once

#include "common/session.h"
#include "formula/planar/solve_rotation.h"

namespace findspace::app {

/// Whether `check` or `measure` looks at a pose: --angle is given, or the scene or its formula rotates the moving
/// shape.
bool asks_for_angle(const Session& session);
Outcome check_at_angle(const Session& session);
Outcome measure_at_angle(const Session& session);
Outcome map_of_angles(const Session& session);
Outcome map_of_poses(const Session& session);
/// Whether the scene gives some angles, in the plane.
bool asks_for_poses(const Session& session);
Outcome explain_poses(const Session& session);
/// The formula of a map over angles; throws where the scene asks for what is not computed over them.
formula::Formula question_over_angles(const Session& session);

}  // namespace findspace::app
