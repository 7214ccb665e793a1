// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verbs map, check, measure, describe and convert for 3D scenes: the same options and the same results as in the
// plane, one dimension higher. Each is called by its verb once the scene is read and known to be 3D.
#pragma once

#include "session.h"
#include "situation/solve_space.h"

namespace findspace::app {

/// The scene's shapes as sets and bodies.
situation::SpaceWorld space_world(const Session& session);

Outcome map_space(const Session& session);
/// On `resolution` x `resolution` lines, of one axis or of all three.
Outcome map_rays(const Session& session, int resolution, bool axes);
/// The positions on the scene's line.
Outcome map_space_line(const Session& session);
Outcome check_space(const Session& session);
Outcome measure_space(const Session& session);
Outcome describe_space(const Session& session, const std::string& shape);
Outcome convert_space(const Session& session, const std::string& shape);

}  // namespace findspace::app
