// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The shapes of a scene in space, ready for questions: as sets and bodies, and for lines. Guarantee: what had to be
// rounded is said. Cost: side by side, that of building each.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/solid/solve_space.h"
#include "io/draw/draw_bodies.h"
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
/// Whether a picture of the scene draws a shape by its members: a list whose members are all shapes of the scene.
bool drawn_by_members(const AskedScene& asked, const std::string& name);
/// The bodies of the scene for a picture, which lives no longer than what is returned; the moving ones at a place, or
/// not at all.
using KeptBodies = std::vector<std::shared_ptr<const void>>;
KeptBodies add_bodies(BodiesPicture& picture, const AskedScene& asked, const formula::SpaceWorld& world,
                      const std::optional<space::Place3>& moving_at);
/// Says what was rounded to make the parts of a body, if it has been made.
void note_rounding(const AskedScene& asked, const std::string& name, const formula::SpaceShape& shape);

}  // namespace findspace::io
