// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The numbers of the command line: --at, --time and --angle, as exact as they are written. A number that is none, or
// not one of the scene, is an Error(kUsage).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/session.h"

namespace findspace::app {

/// --at, or (0, 0), in the scene's unit.
exact::RealPoint asked_position(const Session& session);
/// The same as it was written; nothing without it.
std::optional<Point> asked_point(const Session& session);
std::optional<Point3> asked_point_in_space(const Session& session);
std::array<exact::Real, 3> asked_position_in_space(const Session& session);
/// `count` numbers of --at as they were written; none without it. Not held to the grid's range.
std::vector<Number> asked_coordinates(const Session& session, std::size_t count);
/// --orientation, or --angle about the z axis, of a scene in space.
std::optional<Rotation> asked_rotation(const Session& session);
/// --at, --angle and --time; of a scene in space --at alone.
Pose asked_pose(const Session& session);

}  // namespace findspace::app
