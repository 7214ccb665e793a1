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
#include "formula/solid/solve_space.h"
#include "io/mesh/write_mesh.h"
#include "io/write/write_json.h"

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
/// The lines of a map (or shape) that has no exact form, where none were asked for; a note says so.
LineChoice lines_unasked(const Session& session, const char* what);

}  // namespace findspace::app
