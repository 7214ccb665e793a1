// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene that was read, as the public headers show it.
#pragma once

#include <findspace/world.h>

#include <string_view>

#include "formula/planar/world.h"
#include "io/scene/scene.h"
#include "io/scene/scene_formulas.h"

namespace findspace::io {

/// The motion of its shapes, in grid steps.
formula::Motion motion_of(const Scene& scene);
/// A shape of the scene. Throws Error(kUnknownName).
Shape public_shape(const Scene& scene, std::string_view name);
/// Of the plane, with the sets that were built of its shapes.
World public_world(const Scene& scene, formula::World built);
/// Of the plane or of space.
World public_world(const Scene& scene);

}  // namespace findspace::io
