// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A board's file with some footprints at new positions. Only the numbers of (at ...) within these footprints change:
// their own, and where they are rotated the angles of their pads and texts, which count from the board's axes; and the
// points of their areas, which stand in the board's coordinates. All other bytes stay. Guarantee: positions are written
// as they are given, on KiCad's grid. Keywords: placement, back annotation.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "exact/number/real.h"
#include "io/board/board.h"

namespace findspace::io {

struct NewPlace {
  plane::GridPoint at;  // of the anchor, in millionths of a millimetre
  exact::Real turn{};   // degrees to add, counter-clockwise as it is seen
};

/// Where a part stands when the part `first`, which it moves with, stands at that place. Where the rotation is no
/// multiple of 90 degrees its anchor is put on the grid.
NewPlace place_beside(const Part& part, const Part& first, const NewPlace& place);

/// `places`: by the names that the board's parts have. Throws Error where a name is none.
std::string moved_board(std::string_view text, const std::string& file, const std::map<std::string, NewPlace>& places);

}  // namespace findspace::io
