// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The exact map of a scene in space: as boxes or as one convex set, the best positions where it has an objective, made
// into what is asked for. Guarantee: exact; where it has neither form its `way` is kLines, and lines have to give it.
// Keywords: feasible region, answer.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/solid/solve_region.h"
#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"
#include "io/question/planar_map.h"

namespace findspace::io {

/// `flat`: the boundary is wanted as flat faces.
formula::SpaceRegion space_map(const AskedScene& asked, const formula::SpaceSolver& solver,
                               const formula::Formula& formula, const Applied& apply, bool flat);
/// As `map --json` prints it; not of kLines. `known`: its summary, where it has been made already.
std::string space_map_json(const AskedScene& asked, const formula::SpaceRegion& map,
                           const space::SpaceSummary* known = nullptr);

/// The public world of a scene, of which this has been made already.
using WorldOfScene = std::function<World(const Scene&, std::shared_ptr<const formula::SpaceSolver>)>;
/// Positions in space; nothing where lines have to give them.
std::optional<Answer::Data> map_of_space(AskedScene asked, const Applied& apply, bool flat,
                                         const WorldOfScene& world_of);

/// JSON, and the endings of surfaces.
std::vector<std::string> space_formats();

}  // namespace findspace::io
