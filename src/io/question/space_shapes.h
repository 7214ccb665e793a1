// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The shapes of a scene in space, ready for questions: as sets and bodies, and for lines. Guarantee: what had to be
// rounded is said. Cost: side by side, that of building each.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "formula/solid/solve_space.h"
#include "io/question/asked_scene.h"

namespace findspace::io {

/// Shapes of the scene, and such made of them, as sets and bodies, by name.
std::map<std::string, formula::SpaceShape> space_shapes(const AskedScene& asked,
                                                        const std::vector<plane::ShapePtr>& shapes);
formula::SpaceWorld space_world(const AskedScene& asked);
/// Of that, kept where the scene is prepared.
std::shared_ptr<const formula::SpaceSolver> space_solver(const AskedScene& asked);
/// The scene's shapes for rays; refers to them.
formula::RayWorld ray_world(const AskedScene& asked);
/// Says what was rounded to make the parts of a body, if it has been made.
void note_rounding(const AskedScene& asked, const std::string& name, const formula::SpaceShape& shape);

}  // namespace findspace::io
