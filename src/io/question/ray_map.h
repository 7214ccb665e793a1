// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets of space on parallel lines, for solids of any shape, as answers: numbers, lines, intervals, surface and slices.
// Guarantee: exact on the lines, or on one side of the set there; of what lies between them nothing is said, or cells
// about the lines belong on one side. Cost: one convolution a pair of solids, then a fraction of a millisecond a line.
// Keywords: ray representation, dexel.
#pragma once

#include <string>
#include <string_view>

#include "io/mesh/write_mesh.h"
#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"
#include "io/question/planar_map.h"
#include "io/question/ray_set.h"

namespace findspace::io {

/// How a map is taken on lines.
struct RayChoice {
  LineChoice lines{};
  formula::Side side = formula::Side::kNone;  // of the cells about them
  bool listed = true;                         // JSON has the lines
};

/// What a question says; kBadValue for lines that are none, kUsage where messages put "--" `before` "step".
RayChoice ray_choice(const AskedScene& asked, const MapLines& lines, std::string_view before, bool listed);
/// Those of a map (or shape) that has no exact form, where none were asked for; a note says so. `count`: each way; 0:
/// as usual.
RayChoice usual_lines(const AskedScene& asked, std::string_view what, std::string_view before, bool listed,
                      int count = 0);

/// The positions of the scene's formula. Nothing can be made of them: an operation is refused.
Answer::Data map_on_lines(AskedScene asked, const RayChoice& choice, const Applied& apply);
/// A shape of the scene.
Answer::Data shape_on_lines(AskedScene asked, const std::string& name, const RayChoice& choice);

/// The surface of a shape as `count` lines each way give it.
Surface surface_on_lines(const plane::Shape& shape, int count, double step);

}  // namespace findspace::io
