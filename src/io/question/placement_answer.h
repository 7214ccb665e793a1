// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene answers that says what to place, in the plane and in space. The verb `place`. Guarantee: that of the
// placement (planning/); where a limit came first, or lines were looked at, the answer is undecided. Keywords: nesting,
// layout.
#pragma once

#include <string>

#include "io/question/answer_data.h"
#include "io/question/asked_scene.h"
#include "planning/order/problem.h"

namespace findspace::io {

struct PlacementQuestion {
  planning::Limit limit{};
  int lines = 0;         // in space, each way, where positions are taken on lines; 0: as usual
  std::string source{};  // of a board: its text
};

Answer::Data place_in_plane(AskedScene asked, const PlacementQuestion& question);
Answer::Data place_in_space(AskedScene asked, const PlacementQuestion& question);

}  // namespace findspace::io
