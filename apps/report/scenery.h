// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a picture of positions shows beside them: the shapes of the scene, their motion and its unit.
#pragma once

#include <string>
#include <vector>

#include "common/session.h"
#include "io/board/board.h"

namespace findspace::app {

/// The moving shapes of a picture, and the fixed ones of which the formula speaks (all without one). The regions are
/// those of `world`.
void add_scenery(const Session& session, io::Picture& picture, const formula::World& world,
                 const formula::Formula* formula);

/// Pads of the parts that stand still, tracks, vias and holes, layer by layer; `moving`: names of shapes.
std::vector<io::CopperLayer> copper_of(const io::Board& board, const std::vector<std::string>& moving, double step);

/// Whether it is a part whose body is on the back alone; `board` may be null.
bool is_behind(const io::Board* board, std::string_view part);

}  // namespace findspace::app
