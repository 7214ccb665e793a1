// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The arrows of a picture: how the shapes of a scene move, and along or about what its distances are measured.
#pragma once

#include <vector>

#include "formula/planar/solve.h"
#include "io/draw/draw_arrows.h"
#include "io/scene/scene.h"

namespace findspace::io {

/// `formula` may be null. Ways begin in the middle of the shapes as the world has them.
std::vector<Arrow> motion_arrows(const Scene& scene, const formula::World& world, const formula::Formula* formula);

}  // namespace findspace::io
