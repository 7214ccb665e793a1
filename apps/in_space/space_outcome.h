// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the verbs map and describe share in 3D: files and formats, notes, and a convex set as an answer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/line_choice.h"
#include "common/session.h"
#include "io/mesh/write_mesh.h"
#include "io/write/write_json.h"
#include "space/box/convex_set.h"

namespace findspace::app {

/// JSON, and the endings of surfaces.
std::vector<std::string> space_formats();
/// JSON, and the surface in every format.
Writers space_writers(std::function<std::string()> json, std::function<io::Surface()> surface, const std::string& title,
                      const std::string& unit);
/// `best` may be null.
Outcome polytope_outcome(const Session& session, const space::ConvexSet& set, const exact::Real& step,
                         const std::string& title, const distance::OptimalValue* best);
/// Whether more than JSON is asked for, which the facets of a grown polytope do not give.
bool wants_surface(const Session& session);
/// Of an answer on lines: those of cells are JSON alone.
void check_lines_outputs(const Session& session, const MapLines& lines);

}  // namespace findspace::app
