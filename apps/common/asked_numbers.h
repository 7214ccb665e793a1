// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The numbers of the command line: --at, --time and --angle, as exact as they are written. A number that is none, or
// not one of the scene, is an Error(kUsage).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/session.h"

namespace findspace::app {

/// A decimal; nothing for other text.
std::optional<Number> decimal(const std::string& text);
/// `count` numbers of --at as they were written; none without it. Not held to the grid's range.
std::vector<Number> asked_coordinates(const Session& session, std::size_t count);
/// The same, as many as the scene has dimensions, within that range.
std::vector<Number> asked_position(const Session& session);
/// --orientation, or --angle about the z axis, of a scene in space.
std::optional<Rotation> asked_rotation(const Session& session);
/// --at, --angle and --time; of a scene in space --at alone.
Pose asked_pose(const Session& session);

}  // namespace findspace::app
