// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene that was read, as the public headers show it.
#pragma once

#include <findspace/board.h>
#include <findspace/scene.h>
#include <findspace/world.h>

#include <memory>

#include "formula/planar/solve.h"
#include "formula/solid/solve_space.h"
#include "io/question/asked_scene.h"
#include "io/scene/scene.h"
#include "io/scene/scene_formulas.h"

namespace findspace::io {

/// A scene of a board.
findspace::Scene public_scene(Scene scene, const findspace::Board& board, const findspace::BoardQuestion& question);
/// Of the plane, with the solver that was made of its shapes.
World public_world(const Scene& scene, std::shared_ptr<const formula::Solver> built);
/// Of space, with the solver that was made of its shapes.
World public_solid_world(const Scene& scene, std::shared_ptr<const formula::SpaceSolver> built);
/// Of the plane or of space.
World public_world(const Scene& scene);

/// Of the plane: its formula over all angles of the scene, or at one; and there at a position too.
Explanation explain_poses(const AskedScene& asked, const std::optional<exact::Real>& degrees,
                          const std::optional<exact::RealPoint>& at);
/// Of the plane: its formula over all angles at a position.
Explanation explain_angles(const AskedScene& asked, const exact::RealPoint& at);
/// Of the plane: its formula over all instants of its motion at a position.
Explanation explain_instants(const AskedScene& asked, const exact::RealPoint& at);

}  // namespace findspace::io
