// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rotations of space as scenes state them: degrees about an axis, a quaternion or a matrix (docs/scene.md,
// "Orientations"). Keywords: orientation, axis and angle.
#pragma once

#include "io/scene/scene.h"
#include "io/text/scene_reader.h"

namespace findspace::io {

/// `value` is a number of degrees about `axis` ("x", [1, 1, 0]; without one z), or an object that says all itself.
Orientation read_orientation(const JsonValue& value, const JsonValue* axis, const GridPosition& about,
                             const SceneReader& json, const Label& label);

/// A list of such, or a whole number N: N angles evenly about the z axis.
std::vector<Orientation> read_orientations(const JsonValue& value, const GridPosition& about, const SceneReader& json,
                                           const Label& label);

}  // namespace findspace::io
