// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The key "place" of a scene. Private to src/io.
#pragma once

#include "io/scene/scene.h"
#include "io/scene/scene_shapes.h"

namespace findspace::io {

Placement read_placement(const JsonValue& value, ShapeReader& shapes);

}  // namespace findspace::io
