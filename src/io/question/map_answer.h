// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene answers for all that its "free" ranges over: in the plane positions, those on a line, instants, angles,
// poses; in space positions on a line. The verb `map`. Guarantee: exact, or between bounds where shapes rotate in time
// or about two points (docs/results.md). Keywords: feasible region, configuration space.
#pragma once

#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"
#include "io/question/planar_map.h"
#include "plane/build/transform.h"

namespace findspace::io {

/// Positions in the plane, or on the scene's line. Without `pictures` what only these need is let go of early.
Answer::Data map_of_positions(AskedScene asked, const Applied& apply, bool pictures);
/// At a position in the scene's unit; `place`: the same as it was given.
Answer::Data map_of_instants(AskedScene asked, const exact::RealPoint& at, const std::string& place);
Answer::Data map_of_angles(AskedScene asked, const exact::RealPoint& at);
Answer::Data map_of_poses(AskedScene asked);
/// Positions on the line of a scene of space.
Answer::Data map_of_space_line(AskedScene asked);

/// The formula of a map over angles; throws where the scene asks for what is not computed over them.
formula::Formula question_over_angles(const AskedScene& asked);

/// As public values, times the step.
std::vector<Interval> shown_intervals(const std::vector<plane::LineInterval>& all, const exact::Real& step);
/// Of what is certain, and what is possible.
Answer::Found found_in(bool some, bool possibly);

}  // namespace findspace::io
