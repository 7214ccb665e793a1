// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene asks beyond its formulas: which shape moves, over what the map ranges, motion, placement.
#pragma once

#include "io/scene/scene.h"
#include "io/scene/scene_shapes.h"

namespace findspace::io {

/// Reads `moving`, `free` (with `about` and `angles`), `motion` and `place` of the scene's root object.
void read_question(const JsonValue& root, ShapeReader& shapes, Scene& scene);

}  // namespace findspace::io
