// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a picture of positions shows beside them: the shapes of the scene, their motion and its unit.
#pragma once

#include <string>
#include <vector>

#include "io/question/asked_scene.h"
#include "io/report/board_picture.h"

namespace findspace::io {

/// The moving shapes of a picture, and the fixed ones of which the formula speaks (all without one). The regions are
/// those of `world`.
void add_scenery(const AskedScene& asked, Picture& picture, const formula::World& world,
                 const formula::Formula* formula);

}  // namespace findspace::io
