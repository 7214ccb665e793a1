// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Questions about shapes of space that are rotated: at one orientation of the command line (--orientation, --angle), or
// at each of the scene's ("free": "pose"). Guarantee: each answer is that of the scene whose moving shapes are rotated;
// points that rotation takes off the grid are put on it once, which is said. Keywords: rigid motion, pose.
#pragma once

#include "common/session.h"

namespace findspace::app {

/// The answer of `ask` to the scene at the orientation of the command line; else at each one of the scene, together;
/// else to the scene as it is.
Outcome at_orientations(const Session& session, Outcome (*ask)(const Session&));

/// Of scenes of the plane.
void refuse_orientation(const Options& options);

}  // namespace findspace::app
