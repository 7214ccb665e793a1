// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Arrows that say how shapes move: the way of a motion, the direction of a distance along one, the sense of a turn.
// Keywords: arrowhead, trajectory, vector graphics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_legend.h"

namespace findspace::io {

struct Arrow {
  enum class Kind { kWay, kDirection, kBothWays, kRotation };
  Kind kind = Kind::kWay;
  std::vector<plane::Place> points;  // way points; or one, the direction, or the centre of the rotation
  bool of_moving = false;            // points are seen from the position of the moving shape
};

/// `position` of the moving shape; arrows that need it are left out without it. Directions begin at the position and
/// have a fixed length in pixels.
std::string arrows(const std::vector<Arrow>& all, const Frame& frame, const std::optional<plane::Place>& position);
/// One entry for each kind there is.
std::vector<LegendEntry> arrow_entries(const std::vector<Arrow>& all);

}  // namespace findspace::io
