// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verbs map, describe, convert and place for 3D scenes: the same options and the same results as in
// the plane, one dimension higher. Each is called by its verb once the scene is read and known to be 3D.
#pragma once

#include "common/line_choice.h"
#include "common/session.h"
#include "formula/solid/solve_region.h"
#include "io/mesh/write_mesh.h"
#include "io/question/space_shapes.h"

namespace findspace::app {

Outcome map_space(const Session& session);
Outcome map_rays(const Session& session, const LineChoice& lines);
Outcome describe_space(const Session& session, const std::string& shape);
Outcome convert_space(const Session& session, const std::string& shape);
/// The boundary of a shape that one surface of flat faces bounds; throws Error(kUnsupported) for others.
io::Surface boundary_of(const Session& session, const plane::Shape& shape);

}  // namespace findspace::app
