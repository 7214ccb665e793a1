// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The exact map of a scene in space: as boxes or as one convex set, the best positions where it has an objective, made
// into what is asked for. Guarantee: exact; where it has neither form lines have to give it.
// Keywords: feasible region, answer.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "formula/solid/solve_region.h"
#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"
#include "io/question/planar_map.h"

namespace findspace::io {

/// The public world of a scene, of which this has been made already.
using WorldOfScene = std::function<World(const Scene&, std::shared_ptr<const formula::SpaceSolver>)>;
/// Positions in space; nothing where lines have to give them. `flat`: the boundary is wanted as flat faces.
std::optional<Answer::Data> map_of_space(AskedScene asked, const Applied& apply, bool flat,
                                         const WorldOfScene& world_of);

}  // namespace findspace::io
