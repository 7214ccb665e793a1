// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays from the positions at which a solid B touches the surface of a solid A (touch_frontier.h): how near
// they are, for depths and for how far B is from fitting, and the farthest of them. Guarantee: exact on every line.
// Cost: the frontier, and line_pieces.h for each of its pieces near a line. Keywords: offset surface, penetration
// depth.
#pragma once

#include <limits>

#include "space/rays/ray_sources.h"
#include "space/surface/touch_frontier.h"

namespace findspace::space {

struct TouchPair {
  std::shared_ptr<const RaySheet> a, b;
  TouchSide side = TouchSide::kOutside;
  std::size_t most_pairs = std::numeric_limits<std::size_t>::max();  // of facets whose boxes meet
};

/// Both are null where more facets meet than are allowed.

/// - nearer to a touching position than the level (more than 0, in steps), 0 at that distance, + beyond.
RaySourcePointer near_touching(const TouchPair& pair, const exact::Real& level, const RayGrid& grid);
/// - where all touching positions are nearer than the level, 0 where the farthest is at that distance, + elsewhere and
/// where there are none.
RaySourcePointer all_touching_near(const TouchPair& pair, const exact::Real& level, const RayGrid& grid);

}  // namespace findspace::space
