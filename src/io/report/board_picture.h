// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A board in pictures: its copper layer by layer, and which parts are drawn behind others.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/board/board.h"
#include "io/write/write_svg.h"

namespace findspace::io {

/// Pads of the parts that stand still, tracks, vias and holes, layer by layer; `moving`: names of shapes.
std::vector<CopperLayer> copper_of(const Board& board, const std::vector<std::string>& moving, double step);

/// Whether it is a part whose body is on the back alone; `board` may be null.
bool is_behind(const Board* board, std::string_view part);

}  // namespace findspace::io
